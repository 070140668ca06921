// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Closed geodesics on a surface.
#ifndef dggLoopFinder_h
#define dggLoopFinder_h

#include "dggPathFinder.h" // for paths between points

#include <memory> // for the internals
#include <vector> // for the loops

namespace dgg
{
struct FoundLoop
{
  /// Closed: the last point is the first one again. Empty when there is no loop.
  SurfacePath Loop;
  /// The smaller angle of the loop where it starts and ends, radians, pi at most: pi when it is a
  /// closed geodesic, less when it has a kink there, at the point that it was asked to go through.
  double Angle = Pi;
};

/// Finds closed geodesics. What it is made from must outlive it. Loops may be found in several
/// threads at once.
class LoopFinder
{
public:
  /// As PathFinder::PathFinder().
  LoopFinder(const SurfaceMesh& mesh, const GraphSearch& search, const GraphBuilder* builder,
    const double* positions);
  ~LoopFinder();
  LoopFinder(const LoopFinder&) = delete;
  LoopFinder& operator=(const LoopFinder&) = delete;

  /// The shortest geodesic from a point back to itself that was found: ways through the graph that
  /// come from the point on two sides and meet in a straight line are straightened, the shortest
  /// first. The loop has a kink at the point unless `taut`: then it is let go there, and pulled
  /// tight to a closed geodesic close to it. Empty when there is none, as on most surfaces without
  /// a handle or a limb.
  Status ThroughPoint(const SurfacePoint& point, bool taut, FoundLoop& loop) const;

  /// Closed geodesics that cannot be contracted, pulled tight from the shortest loops of mesh edges
  /// through vertex `base` that generate all others: two for each handle of its component, one for
  /// each boundary but the last, one for each cross-cap. The shortest first. Fails on a component
  /// with non-manifold edges.
  Status AroundHandles(Id base, std::vector<FoundLoop>& loops) const;

  /// A rope through points in cyclic order, the last one being joined to the first one: shortest
  /// paths between them, or, when `taut`, what they become when the rope is let go at the points
  /// and pulled tight. Empty when the points are not connected or the rope contracts to a point.
  Status Rope(const std::vector<SurfacePoint>& points, bool taut, FoundLoop& loop) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
