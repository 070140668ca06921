// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Closed geodesics on a surface.
#ifndef dggLoopFinder_h
#define dggLoopFinder_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggFoundLoop.h"  // for FoundLoop
#include "dggPathFinder.h" // for paths between points

#include <memory> // for the internals
#include <vector> // for the loops

namespace dgg
{
/// Finds closed geodesics. What it is made from must outlive it. Loops may be found in several
/// threads at once.
class DGG_CORE_EXPORT LoopFinder
{
public:
  /// As PathFinder::PathFinder(). `linkAccuracy` is that of the links of points that are not
  /// vertices; 0: that of the graph, or 0.01 when it has none (a SaddleVertexGraph).
  LoopFinder(const SurfaceMesh& mesh, const GraphSearch& search, const GraphBuilder* builder,
    const double* positions, double linkAccuracy = 0.0);
  ~LoopFinder();
  LoopFinder(const LoopFinder&) = delete;
  LoopFinder& operator=(const LoopFinder&) = delete;

  /// The shortest geodesic from a point back to itself that was found: ways through the graph that
  /// come from the point on two sides and meet without a wide kink are straightened, the shortest
  /// first, at most 256 of them. The loop has a kink at the point unless `taut`: then it is let go
  /// there, and pulled tight to a closed geodesic close to it. Empty when there is none, as on most
  /// surfaces without a handle or a limb.
  Status ThroughPoint(const SurfacePoint& point, bool taut, FoundLoop& loop,
    const ProgressCallback& progress = {}) const;

  /// A rope through points in cyclic order, the last one being joined to the first one: shortest
  /// paths between them, or, when `taut`, what they become when the rope is let go at the points
  /// and pulled tight. Empty when the points are not connected or the rope contracts to a point;
  /// `isConnected` distinguishes these. Stopped before any of the paths, there is no rope.
  Status Rope(const std::vector<SurfacePoint>& points, bool taut, FoundLoop& loop,
    bool& isConnected, const ProgressCallback& progress = {}) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
