// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMeshChecks.h"

#include "dggFileText.h"
#include "dggPolygonTriangulator.h"

#include <algorithm>
#include <limits>

namespace
{
using dgg::CellList;
using dgg::DataArray;
using dgg::FileCode;

/// Doubles hold all integers below this one.
constexpr std::int64_t FirstRounded = std::int64_t(1) << 53;

template <typename Worker>
void ForEachValue(const DataArray& array, const Worker& worker)
{
  std::visit([&worker](const auto& values) { std::for_each(values.begin(), values.end(), worker); },
    array.Values);
}

std::size_t GetNumberOfRows(const DataArray& array)
{
  return std::visit([](const auto& values) { return values.size(); }, array.Values) /
    static_cast<std::size_t>(array.Components);
}

void CheckArrays(const std::vector<DataArray>& arrays, const char* kind, std::size_t count)
{
  for (const DataArray& array : arrays)
  {
    if (GetNumberOfRows(array) != count)
    {
      dgg::Fail(FileCode::Malformed, "the ", kind, " array ", array.Name, " has ",
        GetNumberOfRows(array), " values for ", count, " ", kind, "s");
    }
  }
}

/// Removes cells without points. Appends to `areKept` for each cell.
void RemoveEmpty(CellList& list, std::vector<bool>& areKept)
{
  std::vector<std::int64_t> kept = { 0 };
  for (std::size_t i = 1; i < list.Offsets.size(); ++i)
  {
    areKept.push_back(list.Offsets[i] > list.Offsets[i - 1]);
    if (areKept.back())
    {
      kept.push_back(list.Offsets[i]);
    }
  }
  list.Offsets = std::move(kept);
}

/// Removes the values of removed cells.
void RemoveValues(const std::vector<bool>& areKept, DataArray& array)
{
  const int components = array.Components;
  std::visit(
    [&](auto& values) {
      std::decay_t<decltype(values)> kept;
      for (std::size_t i = 0; i < areKept.size(); ++i)
      {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(i) * components;
        kept.insert(kept.end(), first, first + (areKept[i] ? components : 0));
      }
      values = std::move(kept);
    },
    array.Values);
}

bool HasLargeIntegers(const DataArray& array)
{
  bool isLarge = false;
  ForEachValue(array, [&isLarge](auto value) {
    if constexpr (std::is_integral_v<decltype(value)> && sizeof(value) == 8)
    {
      using Limits = std::numeric_limits<decltype(value)>;
      const auto limit = static_cast<decltype(value)>(FirstRounded);
      isLarge = isLarge || value >= limit ||
        (Limits::is_signed && value <= static_cast<decltype(value)>(-FirstRounded));
    }
  });
  return isLarge;
}
}

void dgg::CheckMesh(MeshData& mesh)
{
  const std::size_t count = mesh.GetNumberOfPoints();
  CellList* const lists[] = { &mesh.Verts, &mesh.Lines, &mesh.Polygons };
  std::size_t cells = 0;
  for (const CellList* list : lists)
  {
    cells += list->GetCount();
    for (const std::int64_t id : list->Connectivity)
    {
      if (id < 0 || id >= static_cast<std::int64_t>(count))
      {
        Fail(FileCode::Malformed,
          "a cell has a point id that is out of range: the number of points is ", count);
      }
    }
  }
  CheckArrays(mesh.PointArrays, "point", count);
  CheckArrays(mesh.CellArrays, "cell", cells);
  std::vector<bool> areKept;
  for (CellList* list : lists)
  {
    RemoveEmpty(*list, areKept);
  }
  if (std::find(areKept.begin(), areKept.end(), false) != areKept.end())
  {
    for (DataArray& array : mesh.CellArrays)
    {
      RemoveValues(areKept, array);
    }
  }
}

void dgg::WarnOfRounding(MeshData& mesh)
{
  for (const std::vector<DataArray>* arrays : { &mesh.PointArrays, &mesh.CellArrays })
  {
    for (const DataArray& array : *arrays)
    {
      if (HasLargeIntegers(array))
      {
        mesh.Warnings.push_back("The array " +
          (array.Name.empty() ? "(without a name)" : array.Name) +
          " has integers of 2^53 or more, which a PLY file rounds.");
      }
    }
  }
}

void dgg::TriangulatePolygons(MeshData& mesh)
{
  CellList& polygons = mesh.Polygons;
  const auto isTriangle = [&polygons](std::size_t i) {
    return polygons.Offsets[i + 1] - polygons.Offsets[i] == 3;
  };
  std::size_t first = 0;
  while (first < polygons.GetCount() && isTriangle(first))
  {
    ++first;
  }
  if (first == polygons.GetCount())
  {
    return;
  }
  if (mesh.GetNumberOfPoints() > static_cast<std::size_t>(std::numeric_limits<Id>::max()))
  {
    Fail(FileCode::Malformed,
      "the polygons have too many points to be divided into triangles. "
      "Divide them before");
  }
  PolygonTriangulator triangulator(mesh.Points.data());
  CellList triangles;
  std::vector<Id> corners;
  std::vector<Id> ids;
  for (std::size_t i = 0; i < polygons.GetCount(); ++i)
  {
    corners.assign(polygons.Connectivity.begin() + polygons.Offsets[i],
      polygons.Connectivity.begin() + polygons.Offsets[i + 1]);
    ids.clear();
    triangulator.Triangulate(corners, ids);
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      triangles.Connectivity.push_back(ids[k]);
      if (k % 3 == 2)
      {
        triangles.EndCell();
      }
    }
  }
  polygons = std::move(triangles);
  mesh.CellArrays.clear();
}
