// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggRelays.h"

#include "dggCornerModel.h"

#include <algorithm>
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
  auto look = [&](Id neighbor, double length, double angle) {
    const double d = distances[neighbor];
    if (d < Infinity)
    {
      const double miss = shorter.At(length, angle) - d;
      const double longerMiss = longer.At(length, angle) - d;
      gain += std::max(0.0, miss) - std::max(0.0, longerMiss);
      shortfall += std::max(0.0, -longerMiss) - std::max(0.0, -miss);
    }
  };
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    look(mesh.Destination(*g), mesh.Length(*g), mesh.PolarAngle(*g));
    const Id incoming = SurfaceMesh::Previous(*g);
    if (mesh.Twin(incoming) == NoId)
    {
      look(
        mesh.Origin(incoming), mesh.Length(incoming), mesh.PolarAngle(*g) + mesh.CornerAngle(*g));
    }
  }
  return LargestShortfall * gain > shortfall;
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
}
