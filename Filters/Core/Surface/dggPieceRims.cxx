// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceRims.h"

#include "dggCoincidentPoints.h"
#include "dggPoint3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

namespace dgg
{
namespace
{
using Edge = std::array<Id, 2>;

/// Largest difference between coordinates of the same point in two pieces that each computed the
/// point, as a fraction of the largest coordinate: a few ulps.
constexpr double FloatRounding = 0x1p-22;
constexpr double DoubleRounding = 0x1p-50;

void AddEdge(Offset a, Offset b, std::vector<Edge>& edges)
{
  if (a != b)
  {
    edges.push_back({ { static_cast<Id>(std::min(a, b)), static_cast<Id>(std::max(a, b)) } });
  }
}

/// Returns the edges with a single face. The points of the piece are numbered from `first` on.
std::vector<Edge> FindRim(const SurfacePiece& piece, Id first)
{
  std::vector<Edge> edges;
  const CellArrays& polygons = piece.Cells[2];
  for (Offset i = 0; i < polygons.NumberOfCells; ++i)
  {
    const Offset* end = polygons.End(i);
    for (const Offset* id = polygons.Begin(i); id != end; ++id)
    {
      AddEdge(*id, id + 1 == end ? *polygons.Begin(i) : id[1], edges);
    }
  }
  const CellArrays& strips = piece.Cells[3];
  for (Offset i = 0; i < strips.NumberOfCells; ++i)
  {
    for (const Offset* id = strips.Begin(i); strips.End(i) - id > 2; ++id)
    {
      AddEdge(id[0], id[1], edges);
      AddEdge(id[1], id[2], edges);
      AddEdge(id[0], id[2], edges);
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

std::vector<Id> FindEnds(const std::vector<Edge>& rim)
{
  std::vector<Id> ids;
  for (const Edge& edge : rim)
  {
    ids.insert(ids.end(), edge.begin(), edge.end());
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

/// Point on the boundary of a piece.
struct RimPoint
{
  std::size_t Piece;
  Id Point;  // id among the points of all pieces
  Id Common; // equal for points at the same position in the same block

  bool operator<(const RimPoint& other) const
  {
    return std::tie(this->Common, this->Piece) < std::tie(other.Common, other.Piece);
  }
};

/// Sets `Common` of the points from index `begin` on: those of one block, at the given positions.
void FindCommon(std::vector<RimPoint>& points, std::size_t begin,
  const std::vector<double>& positions, double rounding)
{
  double largest = 0.0;
  for (const double x : positions)
  {
    largest = std::max(largest, std::abs(x));
  }
  std::vector<Id> ids(positions.size() / 3);
  std::iota(ids.begin(), ids.end(), 0);
  const std::vector<Id> representatives =
    FindRepresentatives(positions.data(), ids, rounding * largest);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    points[begin + i].Common = static_cast<Id>(begin) + representatives[i];
  }
}

/// Boundary edge between two positions.
struct RimEdge
{
  Edge Common; // the smaller index first
  std::size_t Piece;
  Edge Points; // points at these positions

  bool operator<(const RimEdge& other) const
  {
    return std::tie(this->Common, this->Piece) < std::tie(other.Common, other.Piece);
  }
};

/// Sorts the elements and calls `join(begin, end)` for each run of elements with the same `Common`
/// if all of them belong to different pieces.
template <typename Element, typename Join>
void ForRunsOfDifferentPieces(std::vector<Element>& elements, Join&& join)
{
  std::sort(elements.begin(), elements.end());
  for (auto begin = elements.begin(); begin != elements.end();)
  {
    const auto end = std::find_if(
      begin, elements.end(), [&](const Element& other) { return other.Common != begin->Common; });
    const auto twice = std::adjacent_find(
      begin, end, [](const Element& a, const Element& b) { return a.Piece == b.Piece; });
    if (twice == end)
    {
      join(begin, end);
    }
    begin = end;
  }
}

/// Returns the points of all rims, block by block.
std::vector<RimPoint> CollectPoints(const std::vector<SurfacePiece>& pieces,
  const std::vector<std::vector<Edge>>& rims, double rounding)
{
  std::vector<RimPoint> points;
  std::vector<double> positions; // of the points of the last block
  std::size_t begin = 0;         // index of its first point
  Id first = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    if (p > 0 && pieces[p].Block != pieces[p - 1].Block)
    {
      FindCommon(points, begin, positions, rounding);
      positions.clear();
      begin = points.size();
    }
    for (const Id id : FindEnds(rims[p]))
    {
      const Point3 x = PointAt(pieces[p].Points, id - first);
      if (IsFinite(x)) // other points are never joined; an error about them follows
      {
        points.push_back({ p, id, NoId });
        positions.insert(positions.end(), { x.X, x.Y, x.Z });
      }
    }
    first += static_cast<Id>(pieces[p].NumberOfPoints);
  }
  FindCommon(points, begin, positions, rounding);
  return points;
}

/// Returns the edges of all rims. `common` has the position of each point.
std::vector<RimEdge> CollectEdges(
  const std::vector<std::vector<Edge>>& rims, const std::vector<Id>& common)
{
  std::vector<RimEdge> edges;
  for (std::size_t p = 0; p < rims.size(); ++p)
  {
    for (const Edge& edge : rims[p])
    {
      const bool isOrdered = common[edge[0]] <= common[edge[1]];
      const Edge ends{ { edge[isOrdered ? 0 : 1], edge[isOrdered ? 1 : 0] } };
      const Edge at{ { common[ends[0]], common[ends[1]] } };
      if (at[0] != NoId && at[0] != at[1])
      {
        edges.push_back({ at, p, ends });
      }
    }
  }
  return edges;
}
}

//------------------------------------------------------------------------------
void JoinRims(const std::vector<SurfacePiece>& pieces, DisjointSets& points)
{
  std::vector<std::vector<Edge>> rims;
  Id count = 0;
  for (const SurfacePiece& piece : pieces)
  {
    rims.push_back(FindRim(piece, count));
    count += static_cast<Id>(piece.NumberOfPoints);
  }
  const bool areFloats = std::all_of(pieces.begin(), pieces.end(),
    [](const SurfacePiece& piece) { return piece.AreFromFloats || piece.NumberOfPoints == 0; });
  std::vector<RimPoint> rimPoints =
    CollectPoints(pieces, rims, areFloats ? FloatRounding : DoubleRounding);
  std::vector<Id> common(static_cast<std::size_t>(count), NoId); // per point
  for (const RimPoint& point : rimPoints)
  {
    common[point.Point] = point.Common;
  }
  ForRunsOfDifferentPieces(rimPoints, [&](auto begin, auto end) {
    for (auto point = begin + 1; point != end; ++point)
    {
      points.Join(begin->Point, point->Point);
    }
  });

  std::vector<RimEdge> edges = CollectEdges(rims, common);
  ForRunsOfDifferentPieces(edges, [&](auto begin, auto end) {
    for (auto edge = begin + 1; edge != end; ++edge)
    {
      points.Join(begin->Points[0], edge->Points[0]);
      points.Join(begin->Points[1], edge->Points[1]);
    }
  });
}
}
