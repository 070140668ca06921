// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Straight on over a surface.
#ifndef dggStraightWalk_h
#define dggStraightWalk_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggSurfacePath.h" // for SurfacePath

namespace dgg
{
/// Walk straight on from a point: a straightest geodesic (Polthier and Schmies, "Straightest
/// geodesics on polyhedral surfaces", 1998). It is straight in every face and across edges; through
/// a vertex it goes on with equal angles on both sides. It stops at the boundary, vertices of it
/// included. Across an edge with more than two faces it goes on into the next one in the list of
/// the edge.
///
/// The direction is an angle, radians: at a vertex the polar angle of SurfaceMesh::PolarAngle(),
/// elsewhere that in the frame of the first half-edge of the point's face, 3 * Face. From a point
/// on an edge it may lead out of that face.
///
/// The path ends after `length`, or earlier where it had to stop: see its Length. One point when
/// the length is 0 or there is nowhere to go. Fails when the point does not exist, the angle is not
/// finite or the length is negative or not finite; then the path is empty.
///
/// A walk that has crossed a million edges stops as well.
DGG_CORE_EXPORT Status WalkStraight(const SurfaceMesh& mesh, const SurfacePoint& start,
  double angle, double length, SurfacePath& path);

/// A direction in (-pi, pi], as std::atan2() gives it, as one that WalkStraight() takes: on the
/// boundary polar angles go from 0 to the total angle, and directions that lead out of the surface
/// become the closer one of these two.
DGG_CORE_EXPORT double DirectionAt(
  const SurfaceMesh& mesh, const SurfacePoint& point, double angle);
}

#endif
