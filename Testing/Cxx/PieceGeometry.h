// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lines and polygons of outputs, for comparisons between one process and several.
#ifndef PieceGeometry_h
#define PieceGeometry_h

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace dggtest
{
using Numbers = std::vector<double>;

/// Returns the coordinates of a point of an output.
inline Numbers GetPoint(vtkPolyData* output, vtkIdType id)
{
  const double* const p = output->GetPoint(id);
  return { p[0], p[1], p[2] };
}

/// Calls `visit(line, points)` for the lines of an output.
template <typename Visitor>
void ForEachLine(vtkPolyData* output, const Visitor& visit)
{
  vtkNew<vtkIdList> points;
  for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
  {
    output->GetLines()->GetCellAtId(line, points);
    visit(line, points.Get());
  }
}

/// Appends the values of all arrays except for one.
inline void AppendValues(
  vtkFieldData* data, vtkIdType id, Numbers& numbers, const std::string& except = "")
{
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    for (int i = 0; i < array->GetNumberOfComponents() && except != array->GetName(); ++i)
    {
      numbers.push_back(array->GetComponent(id, i));
    }
  }
}

/// Returns the segments of lines, each with the coordinates of its ends and the values of its line.
inline std::multiset<Numbers> GetSegments(vtkPolyData* output)
{
  std::multiset<Numbers> segments;
  ForEachLine(output, [&](vtkIdType line, vtkIdList* points) {
    for (vtkIdType k = 0; k + 1 < points->GetNumberOfIds(); ++k)
    {
      auto [p, q] =
        std::minmax({ GetPoint(output, points->GetId(k)), GetPoint(output, points->GetId(k + 1)) });
      p.insert(p.end(), q.begin(), q.end());
      AppendValues(output->GetCellData(), line, p);
      segments.insert(p);
    }
  });
  return segments;
}

/// Returns the polygons of an output, each with its values, except for one array, and the
/// coordinates and values of its corners, from the smallest one on.
inline std::multiset<Numbers> GetPolygons(vtkPolyData* output, const std::string& except = "")
{
  std::multiset<Numbers> polygons;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    Numbers polygon;
    AppendValues(output->GetCellData(), cell, polygon, except);
    output->GetCellPoints(cell, ids);
    std::vector<Numbers> corners;
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      corners.push_back(GetPoint(output, ids->GetId(k)));
      AppendValues(output->GetPointData(), ids->GetId(k), corners.back());
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    for (const Numbers& corner : corners)
    {
      polygon.insert(polygon.end(), corner.begin(), corner.end());
    }
    polygons.insert(polygon);
  }
  return polygons;
}
}

#endif
