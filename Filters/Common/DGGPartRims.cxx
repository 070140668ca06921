// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPartRims.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkIncrementalOctreePointLocator.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace
{
using Edge = std::array<dgg::Id, 2>;

/// Largest difference between coordinates of the same point in two parts that each computed the
/// point, as a fraction of the largest coordinate: a few ulps.
constexpr double FloatRounding = 0x1p-22;
constexpr double DoubleRounding = 0x1p-50;

void AddEdge(vtkIdType a, vtkIdType b, std::vector<Edge>& edges)
{
  if (a != b)
  {
    edges.push_back(
      { { static_cast<dgg::Id>(std::min(a, b)), static_cast<dgg::Id>(std::max(a, b)) } });
  }
}

/// Returns the edges with a single face. The points of the part are numbered from `first` on.
std::vector<Edge> FindRim(vtkPolyData* part, dgg::Id first)
{
  std::vector<Edge> edges;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  vtkCellArray* polygons = part->GetPolys();
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    polygons->GetCellAtId(i, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      AddEdge(ids[k], ids[(k + 1) % size], edges);
    }
  }
  vtkCellArray* strips = part->GetStrips();
  for (vtkIdType i = 0; i < strips->GetNumberOfCells(); ++i)
  {
    strips->GetCellAtId(i, size, ids);
    for (vtkIdType k = 0; k + 2 < size; ++k)
    {
      AddEdge(ids[k], ids[k + 1], edges);
      AddEdge(ids[k + 1], ids[k + 2], edges);
      AddEdge(ids[k], ids[k + 2], edges);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> rim;
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if (next - edge == 1)
    {
      rim.push_back({ { first + (*edge)[0], first + (*edge)[1] } });
    }
    edge = next;
  }
  return rim;
}

/// Point on the boundary of a part.
struct RimPoint
{
  int Block;
  std::size_t Part;
  dgg::Id Point; // index among the points of all parts
  std::array<double, 3> Position;
  dgg::Id Place; // equal for points at the same position in the same block

  bool operator<(const RimPoint& other) const
  {
    return std::tie(this->Place, this->Part) < std::tie(other.Place, other.Part);
  }
};

std::vector<dgg::Id> FindEnds(const std::vector<Edge>& rim)
{
  std::vector<dgg::Id> ids;
  for (const Edge& edge : rim)
  {
    ids.insert(ids.end(), edge.begin(), edge.end());
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

/// Numbers the distinct positions of the points of one block from `place` on. Returns the next
/// unused index.
dgg::Id FindPlaces(std::vector<RimPoint>::iterator begin, std::vector<RimPoint>::iterator end,
  bool isDouble, dgg::Id place)
{
  vtkBoundingBox box;
  double largest = 0.0;
  for (auto point = begin; point != end; ++point)
  {
    box.AddPoint(point->Position.data());
    for (const double x : point->Position)
    {
      largest = std::max(largest, std::abs(x));
    }
  }
  double bounds[6];
  box.GetBounds(bounds);
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkIncrementalOctreePointLocator> locator;
  locator->SetTolerance(largest * (isDouble ? DoubleRounding : FloatRounding));
  locator->InitPointInsertion(places, bounds);
  for (auto point = begin; point != end; ++point)
  {
    vtkIdType number = 0;
    locator->InsertUniquePoint(point->Position.data(), number);
    point->Place = place + static_cast<dgg::Id>(number);
  }
  return place + static_cast<dgg::Id>(places->GetNumberOfPoints());
}

/// Boundary edge between two positions.
struct RimEdge
{
  Edge Places; // the smaller index first
  std::size_t Part;
  Edge Points; // points at these positions

  bool operator<(const RimEdge& other) const
  {
    return std::tie(this->Places, this->Part) < std::tie(other.Places, other.Part);
  }
};

/// Calls `join(begin, end)` for each run of `same` elements if all of them belong to different
/// parts. Elements are sorted by parts.
template <typename Element, typename Same, typename Join>
void ForRunsOfDifferentParts(const std::vector<Element>& elements, Same&& same, Join&& join)
{
  for (auto begin = elements.begin(); begin != elements.end();)
  {
    const auto end = std::find_if(
      begin, elements.end(), [&](const Element& other) { return !same(*begin, other); });
    const auto twice = std::adjacent_find(
      begin, end, [](const Element& a, const Element& b) { return a.Part == b.Part; });
    if (twice == end)
    {
      join(begin, end);
    }
    begin = end;
  }
}
}

//------------------------------------------------------------------------------
void DGGJoinRims(const std::vector<DGGSurfacePart>& parts, dgg::DisjointSets& points)
{
  std::vector<std::vector<Edge>> rims;
  std::vector<RimPoint> rimPoints; // block by block, in the order of the parts
  dgg::Id count = 0;
  bool isDouble = false;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    vtkPolyData* part = parts[p].Data;
    rims.push_back(FindRim(part, count));
    for (const dgg::Id point : FindEnds(rims.back()))
    {
      rimPoints.push_back({ parts[p].Block, p, point, {}, dgg::NoId });
      std::array<double, 3>& x = rimPoints.back().Position;
      part->GetPoint(point - count, x.data());
      if (!std::isfinite(x[0] + x[1] + x[2]))
      {
        rimPoints.pop_back(); // not finite: never joined, and reported as an error later
      }
    }
    count += static_cast<dgg::Id>(part->GetNumberOfPoints());
    isDouble |= part->GetPoints() && part->GetPoints()->GetDataType() == VTK_DOUBLE;
  }
  dgg::Id numberOfPlaces = 0;
  for (auto begin = rimPoints.begin(); begin != rimPoints.end();)
  {
    const auto end = std::find_if(
      begin, rimPoints.end(), [&](const RimPoint& point) { return point.Block != begin->Block; });
    numberOfPlaces = FindPlaces(begin, end, isDouble, numberOfPlaces);
    begin = end;
  }
  std::vector<dgg::Id> places(static_cast<std::size_t>(count), dgg::NoId); // per point
  for (const RimPoint& point : rimPoints)
  {
    places[point.Point] = point.Place;
  }
  std::sort(rimPoints.begin(), rimPoints.end());
  ForRunsOfDifferentParts(
    rimPoints, [](const RimPoint& a, const RimPoint& b) { return a.Place == b.Place; },
    [&](auto begin, auto end) {
      for (auto point = begin + 1; point != end; ++point)
      {
        points.Join(begin->Point, point->Point);
      }
    });

  std::vector<RimEdge> edges;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (const Edge& edge : rims[p])
    {
      const bool isOrdered = places[edge[0]] <= places[edge[1]];
      const Edge ends{ { edge[isOrdered ? 0 : 1], edge[isOrdered ? 1 : 0] } };
      const Edge at{ { places[ends[0]], places[ends[1]] } };
      if (at[0] != dgg::NoId && at[0] != at[1])
      {
        edges.push_back({ at, p, ends });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  ForRunsOfDifferentParts(
    edges, [](const RimEdge& a, const RimEdge& b) { return a.Places == b.Places; },
    [&](auto begin, auto end) {
      for (auto edge = begin + 1; edge != end; ++edge)
      {
        points.Join(begin->Points[0], edge->Points[0]);
        points.Join(begin->Points[1], edge->Points[1]);
      }
    });
}
