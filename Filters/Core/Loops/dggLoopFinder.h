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
/// Finds closed geodesics. All constructor arguments must outlive the finder. Several threads may
/// find loops simultaneously.
class DGG_CORE_EXPORT LoopFinder
{
public:
  /// Prepares the finder. The other arguments are those of PathFinder. `linkAccuracy` is the
  /// accuracy of the links of points that are not vertices; 0 means the accuracy of the graph, or
  /// 0.01 if the graph has none (a SaddleVertexGraph).
  LoopFinder(const SurfaceMesh& mesh, const GraphSearch& search, const GraphBuilder* builder,
    const double* positions, double linkAccuracy = 0.0);
  ~LoopFinder();
  LoopFinder(const LoopFinder&) = delete;
  LoopFinder& operator=(const LoopFinder&) = delete;

  /// Finds a short geodesic from a point back to itself. Graph paths that leave the point in two
  /// directions and meet without a large kink are straightened, shortest first, at most 256 of
  /// them. The loop has a kink at the point unless `taut`: then the loop is released at the point
  /// and shortened to a nearby closed geodesic. Paths are compared before they are straightened, so
  /// a shorter loop may exist on rough surfaces. The result is empty if no loop is found, as on
  /// most surfaces without a handle or a limb.
  Status ThroughPoint(const SurfacePoint& point, bool taut, FoundLoop& loop,
    const ProgressCallback& progress = {}) const;

  /// Finds a closed curve through points in cyclic order, with the last point joined to the first.
  /// The curve consists of shortest paths between the points or, if `taut`, is the closed geodesic
  /// that results when this curve is released at the points and shortened. The result is empty if
  /// the points are not connected or the curve contracts to a point; `isConnected` distinguishes
  /// these cases. The result is also empty if stopped before the first path is found.
  Status Rope(const std::vector<SurfacePoint>& points, bool taut, FoundLoop& loop,
    bool& isConnected, const ProgressCallback& progress = {}) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
