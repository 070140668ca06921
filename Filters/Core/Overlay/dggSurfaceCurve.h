// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Curves drawn on a surface through given points.
#ifndef dggSurfaceCurve_h
#define dggSurfaceCurve_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggSurfacePath.h"  // for SurfacePath
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for points and parameters

namespace dgg
{
/// A curve on a surface through given points. Unlike other paths it may bend anywhere, so that its
/// points may lie inside faces.
struct SurfaceCurve
{
  /// The curve; of a closed one the last point is the first one again.
  SurfacePath Path;
  /// Per point of the path, where it is among the given points: i at given point i, and between two
  /// of them i plus the part of the way, by length, that lies behind. A closed curve of n given
  /// points ends with n.
  std::vector<double> Parameters;
  /// Per given point, its place in the path. Each has one of its own, also where two follow each
  /// other in the same place.
  std::vector<Offset> GivenPoints;
  bool IsClosed = false;
};

/// Join points of a surface by a curve, in their order and, when it is to be closed, the last with
/// the first. Two points of one face are joined straight, others by an exact shortest path. Nothing
/// is left out: points may be repeated, and the curve may cross itself.
///
/// Fails when a point is not on the mesh, and when two points that follow each other are not
/// connected.
DGG_CORE_EXPORT Status JoinPoints(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points,
  bool isClosed, const ProgressCallback& progress, SurfaceCurve& curve);

/// The smallest face that both points lie in; NoId when there is none.
DGG_CORE_EXPORT Id FindCommonFace(
  const SurfaceMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);
}

#endif
