// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSourceFinding.h"

#include "dggCornerModel.h"
#include "dggEdges.h"
#include "dggForest.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// Merges the virtual sources of all vertices with those of their relays. `relays` is NoId for
/// vertices whose virtual source is a source of the run.
void MergeRelays(const SurfaceMesh& mesh, const std::vector<double>& distances,
  const std::vector<Id>& relays, const ParallelFor& parallel, VirtualSources& sources)
{
  const VirtualSources pieces = sources;
  std::vector<double> relayLengths(relays.size());
  std::transform(relays.begin(), relays.end(), relayLengths.begin(),
    [&](Id relay) { return relay == NoId ? RelayMerger::NoRelay : pieces[relay].Length; });
  const RelayMerger merger(mesh, distances, pieces, std::move(relayLengths), parallel);
  for (const Id v : SortForest(relays))
  {
    const double length =
      merger.FindLength(v, relays[v] == NoId ? RelayMerger::NoRelay : sources[relays[v]].Length);
    if (length != pieces[v].Length)
    {
      sources[v].Length = length;
      sources[v].Offset += pieces[v].Length - length;
    }
  }
}
}

RelayMerger::RelayMerger(const SurfaceMesh& mesh, const std::vector<double>& distances,
  const VirtualSources& sources, std::vector<double> relayLengths, const ParallelFor& parallel)
  : Mesh(mesh)
  , Distances(distances)
  , Sources(sources)
  , RelayLengths(std::move(relayLengths))
  , Lengths(RelayLengths.size())
{
  ForRange(parallel, static_cast<Offset>(this->Lengths.size()), VerticesPerTask,
    [&](Offset begin, Offset end) {
      for (Id v = static_cast<Id>(begin); v < end; ++v)
      {
        const double relayLength = this->RelayLengths[v];
        this->Lengths[v] =
          relayLength > 0.0 ? this->Lengthen(v, relayLength) : this->Sources[v].Length;
      }
    });
}

/// Returns the length up to the virtual source of the relay if that source is better.
double RelayMerger::Lengthen(Id v, double relayLength) const
{
  const VirtualSource& piece = this->Sources[v];
  const double longer = piece.Length + relayLength;
  const CornerModel here(this->Mesh, v, piece, this->Distances[v]);
  const CornerModel before(this->Mesh, v, { 0.0, longer, piece.Angle }, this->Distances[v]);
  return here.IsKnown && IsConfirmed(this->Mesh, v, here, before, this->Distances) ? longer
                                                                                   : piece.Length;
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
      relays[v] = IsStraight(found[tail], found[v]) ? relays[tail] : tail;
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
