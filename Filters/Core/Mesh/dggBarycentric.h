// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Barycentric coordinates in triangles.
#ifndef dggBarycentric_h
#define dggBarycentric_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT

#include <array> // for the coordinates

namespace dgg
{
/// Three corners of a triangle, in space or as barycentric coordinates in a larger triangle.
using TriangleCorners = std::array<std::array<double, 3>, 3>;

///@{
/// Vectors in space.
inline std::array<double, 3> operator-(
  const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}
inline double Dot(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline std::array<double, 3> Cross(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}
///@}

/// Returns true if coordinates are finite, not negative and sum to 1, up to 1e-6.
DGG_CORE_EXPORT bool AreBarycentric(const std::array<double, 3>& coordinates);

/// Returns the barycentric coordinates of the point of a triangle in space that is closest to
/// `position`. For a degenerate triangle only the edges are considered. On a tie the point is on an
/// edge.
DGG_CORE_EXPORT std::array<double, 3> FindClosestInTriangle(
  const TriangleCorners& corners, const std::array<double, 3>& position, double& squaredDistance);

/// Converts barycentric coordinates in a triangle to coordinates in a smaller triangle in its
/// plane. The corners of the smaller triangle have the coordinates `corners` in the larger one.
/// Converted coordinates are negative for a point outside the smaller triangle. Returns false if
/// the corners lie on a line.
DGG_CORE_EXPORT bool ConvertToPart(const TriangleCorners& corners,
  const std::array<double, 3>& coordinates, std::array<double, 3>& inPart);

/// Returns barycentric coordinates in the larger triangle, converted from coordinates in the
/// smaller one.
DGG_CORE_EXPORT std::array<double, 3> ConvertFromPart(
  const TriangleCorners& corners, const std::array<double, 3>& inPart);
}

#endif
