// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Straightest geodesics over a surface.
#ifndef dggStraightWalk_h
#define dggStraightWalk_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggSurfacePath.h" // for SurfacePath

namespace dgg
{
/// Traces a straightest geodesic from a point (Polthier and Schmies, "Straightest geodesics on
/// polyhedral surfaces", 1998). The geodesic is straight in every face and across edges; at an
/// interior vertex it continues with equal angles on both sides. It stops at the boundary,
/// including boundary vertices. At a non-manifold edge it continues into the next face in the list
/// of the edge.
///
/// The direction is an angle in radians: at a vertex the polar angle of SurfaceMesh::PolarAngle(),
/// elsewhere the angle in the frame of the first half-edge of the point's face, 3 * Face. From a
/// point on an edge the direction may lead out of that face.
///
/// The path ends after `length`, or earlier if the geodesic stops (see SurfacePath::Length). The
/// path has a single point if the length is 0 or the direction leads nowhere. Fails if the point
/// does not exist, the angle is not finite, or the length is negative or not finite; then the path
/// is empty.
///
/// The path also ends after crossing a million edges.
DGG_CORE_EXPORT Status WalkStraight(const SurfaceMesh& mesh, const SurfacePoint& start,
  double angle, double length, SurfacePath& path);

/// Converts a direction in (-pi, pi], as returned by std::atan2(), to one that WalkStraight()
/// accepts: on the boundary polar angles range from 0 to the total angle, and directions that lead
/// out of the surface become the closer of these two limits.
DGG_CORE_EXPORT double DirectionAt(
  const SurfaceMesh& mesh, const SurfacePoint& point, double angle);
}

#endif
