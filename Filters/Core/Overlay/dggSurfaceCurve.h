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
  /// The path of the curve; a closed curve repeats its first point at the end.
  SurfacePath Path;
  /// Per point of the path, its parameter: i at given point i, and i plus the fraction of the
  /// length in between. A closed curve of n given points ends with n.
  std::vector<double> Parameters;
  /// Per given point, its index in the path. Indices are distinct, even if consecutive given points
  /// coincide.
  std::vector<Offset> GivenPoints;
  bool IsClosed = false;
};

/// Joins surface points by a curve in their order; a closed curve also joins the last point to the
/// first. Two points of one face are joined by a straight segment, others by an exact shortest
/// path. Points may be repeated, and the curve may cross itself.
///
/// Fails if a point is not on the mesh, or consecutive points are not connected.
DGG_CORE_EXPORT Status JoinPoints(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points,
  bool isClosed, const ProgressCallback& progress, SurfaceCurve& curve);

/// Returns the face with the smallest id that contains both points; NoId if there is none.
DGG_CORE_EXPORT Id FindCommonFace(
  const SurfaceMesh& mesh, const SurfacePoint& a, const SurfacePoint& b);
}

#endif
