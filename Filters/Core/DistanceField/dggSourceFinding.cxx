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
constexpr Offset VerticesPerTask = 1024;

/// Whether the longer of two models of a vertex, which see the source in one direction, is the
/// better one, by its neighbours.
bool IsConfirmed(const SurfaceMesh& mesh, Id v, const CornerModel& shorter,
  const CornerModel& longer, const std::vector<double>& distances)
{
  double gain = 0.0;
  double shortfall = 0.0;
  ForEachNeighbor(mesh, v, [&](Id neighbor, double length, double angle) {
    const double d = distances[neighbor];
    if (d < Infinity)
    {
      const CornerModel::Ray ray = shorter.Along(angle);
      const CornerModel::Ray farther{ longer.Offset, longer.Length, ray.Bend };
      const double miss = ray.At(length) - d;
      const double longerMiss = farther.At(length) - d;
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

/// The vertices of a forest, each behind its parent.
std::vector<Id> SortForest(const std::vector<Id>& parents)
{
  std::vector<Id> order;
  order.reserve(parents.size());
  std::vector<char> isSorted(parents.size(), 0);
  for (std::size_t v = 0; v < parents.size(); ++v)
  {
    const std::size_t first = order.size();
    for (Id u = static_cast<Id>(v); u != NoId && isSorted[u] == 0; u = parents[u])
    {
      isSorted[u] = 1;
      order.push_back(u);
    }
    std::reverse(order.begin() + static_cast<std::ptrdiff_t>(first), order.end());
  }
  return order;
}

/// Lengthen virtual sources to those before them.
///
/// The last straight piece of a way to a vertex starts at its relay: a vertex at which the way
/// bends, or which it only passes. Ways over the relay reach no more than a narrow wedge behind it;
/// beside that, distances are those from the virtual source of the relay itself, which may explain
/// more of what is around the vertex. Along the rim of a hole the wedges are as narrow as the
/// pieces are short, and faces may be long.
///
/// Distances of neighbours decide. Where the model with the relay predicts too much, another wave
/// may be the nearer one; where that with the source before predicts too little, this source is not
/// visible. So it may miss little in exchange for what it explains.
///
/// `relays` has NoId where the virtual source is a source.
void MergeRelays(const SurfaceMesh& mesh, const std::vector<double>& distances,
  const std::vector<Id>& relays, const ParallelFor& parallel, VirtualSources& sources)
{
  const std::vector<double> pieces = sources.Lengths;
  const auto lengthen = [&](Id v) {
    const double longer = pieces[v] + sources.Lengths[relays[v]];
    const double angle = sources.Angles[v];
    const CornerModel here(mesh, v, distances[v] - pieces[v], pieces[v], angle);
    const CornerModel before(mesh, v, distances[v] - longer, longer, angle);
    return here.IsKnown && IsConfirmed(mesh, v, here, before, distances) ? longer : pieces[v];
  };
  // First with every relay as it was found, then once more behind those that were merged.
  std::vector<double> lengths = pieces;
  ForRange(
    parallel, static_cast<Offset>(relays.size()), VerticesPerTask, [&](Offset begin, Offset end) {
      for (Id v = static_cast<Id>(begin); v < end; ++v)
      {
        if (relays[v] != NoId && pieces[relays[v]] > 0.0)
        {
          lengths[v] = lengthen(v);
        }
      }
    });
  for (const Id v : SortForest(relays))
  {
    const bool isRelayMerged = relays[v] != NoId && sources.Lengths[relays[v]] != pieces[relays[v]];
    sources.Lengths[v] = isRelayMerged ? lengthen(v) : lengths[v];
    if (sources.Lengths[v] != pieces[v])
    {
      sources.Offsets[v] += pieces[v] - sources.Lengths[v];
    }
  }
}
}

void FindVirtualSources(const SurfaceMesh& mesh, const SearchResult& result,
  const std::vector<double>& distances, VirtualSources& found, const ParallelFor& parallel)
{
  found = result.Virtual;
  std::vector<Id> relays(result.Tails.size(), NoId);
  for (const Id v : SortForest(result.Tails))
  {
    const Id tail = result.Tails[v];
    if (tail != NoId)
    {
      // With the offset of the tail, the way goes straight on over it; else it is the relay.
      const bool isStraight = found.Offsets[v] == found.Offsets[tail];
      relays[v] = isStraight ? relays[tail] : tail;
    }
  }
  MergeRelays(mesh, result.Corrected, relays, parallel, found);
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    if (distances[v] < Infinity)
    {
      found.Offsets[v] = distances[v] - found.Lengths[v];
    }
  }
}

void FindVirtualSources(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const ExactResult& result, VirtualSources& found, const ParallelFor& parallel)
{
  const std::size_t n = result.Distances.size();
  found.Offsets.assign(n, Infinity);
  found.Lengths.assign(n, Infinity);
  found.Angles.assign(n, 0.0);
  std::vector<Id> relays(n, NoId);
  for (std::size_t i = 0; i < n; ++i)
  {
    if (!(result.Distances[i] < Infinity))
    {
      continue;
    }
    const Id v = static_cast<Id>(i);
    const Predecessor& p = result.Predecessors[v];
    const LastPiece piece = FindLastPiece(mesh, sources, v, p);
    relays[v] = p.Root >= 0 && p.Root != v ? p.Root : NoId;
    found.Offsets[v] = result.Distances[v] - piece.Length;
    found.Lengths[v] = piece.Length;
    found.Angles[v] = piece.Angle;
  }
  MergeRelays(mesh, result.Distances, relays, parallel, found);
}
}
