// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cuts polygons into triangles. Internal.
#ifndef dggPolygonTriangulator_h
#define dggPolygonTriangulator_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggTypes.h"      // for Id

#include <array>  // for points
#include <vector> // for std::vector

namespace dgg
{
/// Triangulates polygons one after the other. A triangle stays as it is. A quad is cut along the
/// shorter of the diagonals that lie inside it. A larger polygon loses its ears one by one, best
/// shape first. A polygon without a triangulation, because it crosses itself, becomes a fan around
/// its first point.
class DGG_CORE_EXPORT PolygonTriangulator
{
public:
  /// `points` are x y z per point, and must outlive this object.
  explicit PolygonTriangulator(const double* points)
    : Points(points)
  {
  }

  /// Appends a triangle. Returns false, without appending, if it names a point twice.
  static bool Append(Id a, Id b, Id c, std::vector<Id>& triangles)
  {
    const bool isTriangle = a != b && b != c && c != a;
    if (isTriangle)
    {
      triangles.insert(triangles.end(), { a, b, c });
    }
    return isTriangle;
  }

  /// Appends the triangles of a polygon, three point ids each, and returns their number; 0 if fewer
  /// than three points are distinct.
  Id Triangulate(const std::vector<Id>& polygon, std::vector<Id>& triangles);

  /// Returns the number of polygons that have become fans, including quads that cross themselves.
  Offset GetNumberOfFans() const { return this->NumberOfFans; }

private:
  using Vector = std::array<double, 3>;

  void Normalize();
  void CutQuad(std::vector<Id>& triangles);
  bool CutEars(std::vector<Id>& triangles);
  void CutFan(std::vector<Id>& triangles) const;

  const double* Points;
  std::vector<Id> Corners;       // without repetitions of the one before
  std::vector<Vector> Positions; // from the first corner, in units of the extent
  Offset NumberOfFans = 0;
};
}

#endif
