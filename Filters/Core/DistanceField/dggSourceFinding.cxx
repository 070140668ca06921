// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSourceFinding.h"

#include "dggCornerModel.h"
#include "dggEdges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dgg
{
namespace
{
/// What a longer virtual source may predict too little, of what the shorter one predicts too much.
/// Measured on scans and CAD models, with exact distances and those of graphs: with less, some of
/// the errors along rims stay; with more, the mean error inside of faces grows on coarse models.
constexpr double LargestShortfall = 0.2;

/// Whether the longer of two models of a vertex is the better one, by its neighbours.
bool IsConfirmed(const SurfaceMesh& mesh, Id v, const CornerModel& shorter,
  const CornerModel& longer, const std::vector<double>& distances)
{
  double gain = 0.0;
  double shortfall = 0.0;
  ForEachNeighbor(mesh, v, [&](Id neighbor, double length, double angle) {
    const double d = distances[neighbor];
    if (d < Infinity)
    {
      const double miss = shorter.At(length, angle) - d;
      const double longerMiss = longer.At(length, angle) - d;
      gain += std::max(0.0, miss) - std::max(0.0, longerMiss);
      shortfall += std::max(0.0, -longerMiss) - std::max(0.0, -miss);
    }
  });
  return LargestShortfall * gain > shortfall;
}

/// The last straight piece of the way to a vertex, as the vertex sees it.
struct LastPiece
{
  double Length = 0.0;
  double Angle = 0.0;
};

/// Through the face of a half-edge, whose apex the vertex is.
LastPiece ThroughFace(const SurfaceMesh& mesh, const Predecessor& p)
{
  const Point2 apex{ mesh.ApexX(p.HalfEdge), mesh.ApexY(p.HalfEdge) };
  const Point2 back{ p.ImageX - apex.X, p.ImageY - apex.Y };
  // The reference of the corner is the edge from the apex to the origin of the half-edge.
  const double angle =
    std::atan2(-apex.X * back.Y + apex.Y * back.X, -apex.X * back.X - apex.Y * back.Y);
  return { Norm(back.X, back.Y), mesh.PolarAngle(SurfaceMesh::Previous(p.HalfEdge)) + angle };
}

/// Along the shortest edge between the two vertices.
LastPiece AlongEdge(const SurfaceMesh& mesh, Id v, Id root)
{
  LastPiece piece{ Infinity, 0.0 };
  ForEachNeighbor(mesh, v, [&](Id neighbor, double length, double angle) {
    if (neighbor == root && length < piece.Length)
    {
      piece = { length, angle };
    }
  });
  return piece;
}

/// Within a face that the source lies in.
LastPiece WithinFace(const SurfaceMesh& mesh, Id v, const SurfacePoint& source)
{
  LastPiece piece{ Infinity, 0.0 };
  ForEachFaceAround(mesh, source, [&](Id f, const std::array<double, 3>& b) {
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Point2 p = PlaceInFrame(mesh, h, b);
      const double length = Norm(p.X, p.Y);
      if (mesh.Origin(h) == v && length < piece.Length)
      {
        piece = { length, mesh.PolarAngle(h) + std::atan2(p.Y, p.X) };
      }
    }
  });
  return piece;
}

LastPiece FindLastPiece(
  const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources, Id v, const Predecessor& p)
{
  if (p.Root == v)
  {
    return {};
  }
  if (p.HalfEdge != NoId)
  {
    return ThroughFace(mesh, p);
  }
  return p.Root >= 0 ? AlongEdge(mesh, v, p.Root) : WithinFace(mesh, v, sources[~p.Root].Point);
}
}

std::vector<Id> SortReached(const std::vector<double>& distances)
{
  std::vector<Id> order;
  order.reserve(static_cast<std::size_t>(
    std::count_if(distances.begin(), distances.end(), [](double d) { return d < Infinity; })));
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    if (distances[v] < Infinity)
    {
      order.push_back(static_cast<Id>(v));
    }
  }
  std::stable_sort(
    order.begin(), order.end(), [&](Id a, Id b) { return distances[a] < distances[b]; });
  return order;
}

void MergeRelays(const SurfaceMesh& mesh, const std::vector<double>& distances,
  const std::vector<Id>& order, const std::vector<Id>& relays, VirtualSources& sources)
{
  for (const Id v : order)
  {
    const Id relay = relays[v];
    if (relay == NoId || !(sources.Lengths[relay] > 0.0))
    {
      continue;
    }
    const double length = sources.Lengths[v];
    const double longer = length + sources.Lengths[relay];
    const double angle = sources.Angles[v];
    const CornerModel here(mesh, v, distances[v] - length, length, angle);
    const CornerModel before(mesh, v, distances[v] - longer, longer, angle);
    if (here.IsKnown && IsConfirmed(mesh, v, here, before, distances))
    {
      sources.Lengths[v] = longer;
      sources.Offsets[v] += length - longer;
    }
  }
}

void FindVirtualSources(const SurfaceMesh& mesh, const SearchResult& result, VirtualSources& found)
{
  found = result.Virtual;
  const std::vector<Id> order = SortReached(result.Distances);
  std::vector<Id> relays(result.Tails.size(), NoId);
  for (const Id v : order)
  {
    const Id tail = result.Tails[v];
    if (tail != NoId)
    {
      // With the offset of the tail, the way goes straight on over it; else it is the relay.
      const bool isStraight = found.Offsets[v] == found.Offsets[tail];
      relays[v] = isStraight ? relays[tail] : tail;
    }
  }
  MergeRelays(mesh, result.Corrected, order, relays, found);
}

void FindVirtualSources(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const ExactResult& result, VirtualSources& found)
{
  const std::size_t n = result.Distances.size();
  found.Offsets.assign(n, Infinity);
  found.Lengths.assign(n, Infinity);
  found.Angles.assign(n, 0.0);
  std::vector<Id> relays(n, NoId);
  const std::vector<Id> order = SortReached(result.Distances);
  for (const Id v : order)
  {
    const Predecessor& p = result.Predecessors[v];
    const LastPiece piece = FindLastPiece(mesh, sources, v, p);
    relays[v] = p.Root >= 0 && p.Root != v ? p.Root : NoId;
    found.Offsets[v] = result.Distances[v] - piece.Length;
    found.Lengths[v] = piece.Length;
    found.Angles[v] = piece.Angle;
  }
  MergeRelays(mesh, result.Distances, order, relays, found);
}
}
