// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSourceFinding.h"

#include "dggCornerModel.h"
#include "dggEdges.h"
#include "dggForest.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Maximum underestimate of a longer virtual source, relative to the overestimate of the shorter
/// one. Measured on scans and CAD models, with exact and graph distances: with smaller values, some
/// of the errors along hole boundaries remain; with larger values, the mean error inside faces
/// grows on coarse models.
constexpr double LargestShortfall = 0.2;
constexpr Offset VerticesPerTask = 1024;

/// Returns true if the neighbors confirm that the longer of two models of a vertex, whose sources
/// lie in the same direction, is better.
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

/// Returns the start of the last straight segment of the path to a vertex, without its offset.
VirtualSource FindLastPiece(
  const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources, Id v, const Predecessor& p)
{
  VirtualSource start;
  const auto offer = [&](double length, double angle) {
    if (length < start.Length)
    {
      start = { Infinity, length, angle };
    }
  };
  if (p.Root == v)
  {
    offer(0.0, 0.0);
  }
  else if (p.HalfEdge != NoId) // through the face whose apex the vertex is
  {
    const Point2 back = Difference({ p.ImageX, p.ImageY }, ApexOf(mesh, p.HalfEdge));
    offer(Norm(back.X, back.Y), PolarAngleAtApex(mesh, p.HalfEdge, back));
  }
  else if (p.Root >= 0) // along an edge
  {
    ForEachNeighbor(mesh, v, [&](Id neighbor, double length, double angle) {
      if (neighbor == p.Root)
      {
        offer(length, angle);
      }
    });
  }
  else // within a face that contains the source
  {
    ForEachFaceAround(mesh, sources[~p.Root].Point, [&](Id f, const std::array<double, 3>& b) {
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Point2 place = PlaceInFrame(mesh, h, b);
        if (mesh.Origin(h) == v)
        {
          offer(Norm(place.X, place.Y), mesh.PolarAngle(h) + std::atan2(place.Y, place.X));
        }
      }
    });
  }
  return start;
}

/// Replaces virtual sources by their predecessors if the predecessors are better.
///
/// The last straight segment of a path to a vertex starts at its relay: a vertex at which the path
/// bends, or through which the path runs straight. Paths through the relay reach only a narrow
/// wedge behind the relay. Beside the wedge, distances are measured from the virtual source of the
/// relay itself, which may explain more distances around the vertex. Along the boundary of a hole
/// the wedges are as narrow as the segments are short, and faces may be long.
///
/// The distances of neighbors decide. If the model with the relay overestimates the distance of a
/// neighbor, another wavefront may be nearer. If the model of the preceding source underestimates
/// the distance, the preceding source is not visible from the neighbor. Therefore the preceding
/// source may only underestimate slightly in exchange for the distances that it explains.
///
/// `relays` is NoId for vertices whose virtual source is a source of the run.
void MergeRelays(const SurfaceMesh& mesh, const std::vector<double>& distances,
  const std::vector<Id>& relays, const ParallelFor& parallel, VirtualSources& sources)
{
  const VirtualSources pieces = sources;
  const auto lengthen = [&](Id v) {
    const double length = pieces[v].Length;
    const double longer = length + sources[relays[v]].Length;
    const CornerModel here(mesh, v, pieces[v], distances[v]);
    const CornerModel before(mesh, v, { 0.0, longer, pieces[v].Angle }, distances[v]);
    return here.IsKnown && IsConfirmed(mesh, v, here, before, distances) ? longer : length;
  };
  // The first pass uses the relays as found; the second pass tests vertices behind merged relays.
  std::vector<double> lengths(relays.size());
  ForRange(
    parallel, static_cast<Offset>(relays.size()), VerticesPerTask, [&](Offset begin, Offset end) {
      for (Id v = static_cast<Id>(begin); v < end; ++v)
      {
        const bool mayMerge = relays[v] != NoId && pieces[relays[v]].Length > 0.0;
        lengths[v] = mayMerge ? lengthen(v) : pieces[v].Length;
      }
    });
  for (const Id v : SortForest(relays))
  {
    const Id relay = relays[v];
    const bool isRelayMerged = relay != NoId && sources[relay].Length != pieces[relay].Length;
    sources[v].Length = isRelayMerged ? lengthen(v) : lengths[v];
    if (sources[v].Length != pieces[v].Length)
    {
      sources[v].Offset += pieces[v].Length - sources[v].Length;
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
      // With the offset of the tail, the path continues straight through the tail; otherwise the
      // tail is the relay.
      const bool isStraight = found[v].Offset == found[tail].Offset;
      relays[v] = isStraight ? relays[tail] : tail;
    }
  }
  MergeRelays(mesh, result.Corrected, relays, parallel, found);
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    if (distances[v] < Infinity)
    {
      found[v].Offset = distances[v] - found[v].Length;
    }
  }
}

void FindVirtualSources(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const ExactResult& result, VirtualSources& found, const ParallelFor& parallel)
{
  const std::size_t n = result.Distances.size();
  found.assign(n, {});
  std::vector<Id> relays(n, NoId);
  for (std::size_t i = 0; i < n; ++i)
  {
    if (!(result.Distances[i] < Infinity))
    {
      continue;
    }
    const Id v = static_cast<Id>(i);
    const Predecessor& p = result.Predecessors[v];
    relays[v] = p.Root >= 0 && p.Root != v ? p.Root : NoId;
    found[v] = FindLastPiece(mesh, sources, v, p);
    found[v].Offset = result.Distances[v] - found[v].Length;
  }
  MergeRelays(mesh, result.Distances, relays, parallel, found);
}
}
