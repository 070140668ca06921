// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLandmarks.h"

#include "dggDisjointSets.h"
#include "dggFarthestPoints.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dgg
{
namespace
{
constexpr std::int16_t LargestCode = std::numeric_limits<std::int16_t>::max();
/// Upper bound of the rounding error of the distances themselves, in steps; far larger than
/// necessary.
constexpr double RoundingOfSteps = 1e-6;
/// Progress weight, within the choice, of each of the two full searches.
constexpr double SearchShare = 0.15;
/// Components smaller than this fraction of the surface (inverse) are searched without landmarks.
constexpr Id SmallestShare = 2 * Landmarks::Count;

std::int16_t Clamp(double code)
{
  return static_cast<std::int16_t>(std::max(0.0, std::min<double>(code, LargestCode)));
}
}

Status Landmarks::Choose(
  const GraphView& graph, const SurfaceMesh* mesh, const ProgressCallback& progress)
{
  DGG_RETURN_IF_ERROR(ReportTo(progress, 0.0));
  this->Codes.resize(graph.NumberOfVertices);
  FarthestPoints field(graph, mesh);
  DGG_RETURN_IF_ERROR(this->ChooseFrom(field, graph, this->ChooseComponents(graph), progress));
  return ReportTo(progress, 1.0);
}

/// Returns a vertex of each of the larger components, in order of decreasing size.
std::vector<Id> Landmarks::ChooseComponents(const GraphView& graph)
{
  DisjointSets sets(static_cast<std::size_t>(graph.NumberOfVertices));
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      sets.Join(v, graph.Targets[e]);
    }
  }
  std::vector<Id> sizes(static_cast<std::size_t>(graph.NumberOfVertices), 0);
  std::vector<Id> starts; // first vertex of each component
  this->Components.resize(sizes.size());
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    this->Components[v] = sets.Find(v);
    if (sizes[this->Components[v]]++ == 0)
    {
      starts.push_back(v);
    }
  }
  const auto sizeOf = [&](Id v) { return sizes[this->Components[v]]; };
  starts.erase(
    std::remove_if(starts.begin(), starts.end(),
      [&](Id v) { return sizeOf(v) == 1 || sizeOf(v) < graph.NumberOfVertices / SmallestShare; }),
    starts.end());
  std::stable_sort(starts.begin(), starts.end(), [&](Id a, Id b) { return sizeOf(a) > sizeOf(b); });
  starts.resize(std::min<std::size_t>(starts.size(), Count));
  return starts;
}

/// Chooses landmarks in the components of `starts`.
Status Landmarks::ChooseFrom(FarthestPoints& field, const GraphView& graph,
  const std::vector<Id>& starts, const ProgressCallback& progress)
{
  if (starts.empty())
  {
    return Status::Success();
  }
  const auto startFrom = [&](const std::vector<Id>& vertices, double done) {
    std::vector<GraphSeed> seeds;
    for (const Id v : vertices)
    {
      seeds.push_back({ v });
    }
    field.Reset();
    return field.Add(seeds, ProgressPart(progress, done, done + SearchShare));
  };
  // Returns the distance of a vertex from the nearest sample, ignoring components without a
  // landmark.
  const auto distanceOf = [&](Id v) {
    const double distance = field.GetDistances()[v];
    return distance < Infinity ? distance : 0.0;
  };
  const auto findFarthest = [&] {
    Id farthest = 0;
    for (Id v = 1; v < graph.NumberOfVertices; ++v)
    {
      farthest = distanceOf(v) > distanceOf(farthest) ? v : farthest;
    }
    return farthest;
  };
  // The first landmark of a component is a tip: the vertex farthest from an arbitrary vertex.
  DGG_RETURN_IF_ERROR(startFrom(starts, 0.0));
  for (const Id start : starts)
  {
    Id tip = start;
    for (Id v = 0; v < graph.NumberOfVertices; ++v)
    {
      tip = distanceOf(v) > distanceOf(tip) && this->AreConnected(v, start) ? v : tip;
    }
    this->Vertices.push_back(tip);
  }
  DGG_RETURN_IF_ERROR(startFrom(this->Vertices, SearchShare));
  Id farthest = findFarthest();
  // Distances larger than that between two tips are clamped; the difference of clamped distances is
  // still at most the distance between two vertices.
  this->Step = distanceOf(farthest) / LargestCode;
  while (this->Vertices.size() < Count && distanceOf(farthest) > 0.0)
  {
    const double done = static_cast<double>(this->Vertices.size()) / Count;
    DGG_RETURN_IF_ERROR(ReportTo(progress, 2.0 * SearchShare + (1.0 - 2.0 * SearchShare) * done));
    this->Vertices.push_back(farthest);
    DGG_RETURN_IF_ERROR(field.Add({ { farthest } }, nullptr));
    farthest = findFarthest();
  }
  return Status::Success();
}

void Landmarks::SetDistances(std::size_t k, const double* distances)
{
  const double perStep = 1.0 / this->Step;
  for (std::size_t v = 0; v < this->Codes.size(); ++v)
  {
    // The code is 0 in other components, where the differences carry no information but remain
    // valid bounds.
    this->Codes[v][k] = distances[v] < Infinity ? Clamp(distances[v] * perStep) : 0;
  }
}

void Landmarks::Aim(const std::vector<GraphSeed>& seeds, Goal& goal) const
{
  goal.Low.fill(0);
  goal.High.fill(LargestCode);
  for (std::size_t k = 0; k < this->Vertices.size(); ++k)
  {
    // Bounds are in steps. A code c represents distances in [c, c + 1].
    double low = Infinity;
    double high = -Infinity;
    for (const GraphSeed& seed : seeds)
    {
      const double start = seed.Distance / this->Step;
      const double code = this->Codes[seed.Vertex][k];
      low = std::min(low, code + start);
      high = std::max(high, code + 1.0 - start);
    }
    goal.Low[k] = Clamp(std::floor(low - 1.0 - RoundingOfSteps));
    goal.High[k] = Clamp(std::ceil(high + RoundingOfSteps));
  }
}
}
