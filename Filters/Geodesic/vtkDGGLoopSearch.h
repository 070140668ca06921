// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops on a surface, and tapes along them. Internal.
#ifndef vtkDGGLoopSearch_h
#define vtkDGGLoopSearch_h

#include "dggFoundLoop.h"    // for FoundLoop
#include "dggSurfacePoint.h" // for SurfacePoint

#include <cstddef> // for numbers
#include <vector>  // for the loops

class vtkDGGGraphProvider;
class vtkDGGMeshAdapter;

/// What became of a loop: values of LoopStatus.
enum class vtkDGGLoopStatus
{
  Found = 0,
  NotFound = 1,
  NotConnected = 2
};

/// The loops that were asked for, and the rims of tapes along them.
struct vtkDGGLoopSet
{
  std::vector<dgg::FoundLoop> Loops; ///< empty where there is none
  std::vector<vtkDGGLoopStatus> Status;
  std::vector<std::vector<dgg::SurfacePath>> Rims; ///< per loop; empty when there are no tapes
  std::size_t LoopsTooLong = 0;                    ///< for their tapes
  double SmallestTapeWidth = 0.0;                  ///< that is wide enough for all loops
};

/// Finds loops.
class vtkDGGLoopSearch
{
public:
  using Points = std::vector<dgg::SurfacePoint>;

  explicit vtkDGGLoopSearch(const vtkDGGMeshAdapter& mesh)
    : Mesh(mesh)
  {
  }

  /// One through each point, on all threads. `positions` are those of the vertices; the graph has
  /// been provided for the mesh.
  dgg::Status RunThroughPoints(vtkDGGGraphProvider& graph, const double* positions,
    const Points& points, bool taut, const dgg::ProgressCallback& progress,
    vtkDGGLoopSet& set) const;
  /// One through all points.
  dgg::Status RunRope(vtkDGGGraphProvider& graph, const double* positions, const Points& points,
    bool taut, const dgg::ProgressCallback& progress, vtkDGGLoopSet& set) const;
  /// Those around handles.
  dgg::Status RunAroundHandles(const dgg::ProgressCallback& progress, vtkDGGLoopSet& set) const;
  /// The rims of tapes along all loops that are not too long.
  dgg::Status AddTapes(
    double width, const dgg::ProgressCallback& progress, vtkDGGLoopSet& set) const;

private:
  const vtkDGGMeshAdapter& Mesh;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGLoopSearch.h
