// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cuts a polygon into triangles. Internal.
#ifndef DGGPolygonTriangulator_h
#define DGGPolygonTriangulator_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggTypes.h"                  // for Id

#include "vtkIdList.h"  // for the triangles
#include "vtkNew.h"     // for vtkNew
#include "vtkPolygon.h" // for the ear cutting

#include <vector> // for std::vector

/// Triangulates polygons one after the other. A triangle stays as it is. A quad is cut along the
/// shorter of the diagonals that lie inside it. A larger polygon loses its ears one by one. A
/// polygon that has no triangulation (it crosses itself) becomes a fan around its first point.
class VTKDGGFILTERSCOMMON_EXPORT DGGPolygonTriangulator
{
public:
  /// Append the triangles of the polygon `corners` (point ids) to `triangles`, three ids each.
  /// Returns how many; none when fewer than three points are distinct. `points` are x y z per
  /// point.
  dgg::Id Triangulate(
    const double* points, const std::vector<dgg::Id>& corners, std::vector<dgg::Id>& triangles);

  /// How many polygons have become fans since construction.
  vtkIdType GetNumberOfFans() const { return this->NumberOfFans; }

private:
  void CutQuad(const double* points, std::vector<dgg::Id>& triangles);
  void CutEars(const double* points, std::vector<dgg::Id>& triangles);

  std::vector<dgg::Id> Corners; // without repetitions of the one before
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Ears;
  vtkIdType NumberOfFans = 0;
};

#endif
