// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Closed geodesics on a surface, and offset curves along them. Internal.
#ifndef dggLoopSearch_h
#define dggLoopSearch_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggFoundLoop.h"    // for FoundLoop
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the loops

namespace dgg
{
class GraphSession;
struct Output;
struct TaskContext;

struct LoopOptions
{
  enum KindType
  {
    ThroughPoint,  ///< a loop through each point
    AroundHandles, ///< loops that generate the fundamental group; there are no points
    Rope           ///< one loop through all points, in their order
  };

  KindType Kind = ThroughPoint;
  std::vector<SurfacePoint> Points;
  bool Taut = false;      ///< release loops at the points
  double TapeWidth = 0.0; ///< distance between two offset curves; 0 for none
};

/// Loops and the offset curves along them.
struct LoopSet
{
  enum StatusType
  {
    Found = 0,
    NotFound = 1,
    NotConnected = 2 ///< the points of a rope
  };

  std::vector<FoundLoop> Loops; ///< empty if not found
  std::vector<StatusType> Status;
  std::vector<std::vector<SurfacePath>> OffsetCurves; ///< per loop; empty without tapes
};

/// Fails for a width that is negative or not finite.
DGG_CORE_EXPORT Status CheckTapeWidth(double width);
/// Fails for a rope through fewer than three different points.
DGG_CORE_EXPORT Status CheckLoopOptions(const LoopOptions& options);

/// Finds loops. `graph` must be up to date; it is not used around handles.
DGG_CORE_EXPORT Status FindLoops(
  const TaskContext& context, GraphSession& graph, const LoopOptions& options, LoopSet& loops);

///@{
/// Writes the loops that exist as lines with the cell arrays `Length`, `LoopId`, `Angle` and
/// `Kinked` and the field array `LoopStatus`; the offset curves with `Length` and `LoopId`. Warns
/// about what is missing.
DGG_CORE_EXPORT void WriteLoops(
  const TaskContext& context, const LoopOptions& options, const LoopSet& loops, Output& output);
DGG_CORE_EXPORT void WriteOffsetCurves(
  const TaskContext& context, const LoopOptions& options, const LoopSet& loops, Output& output);
///@}
}

#endif
