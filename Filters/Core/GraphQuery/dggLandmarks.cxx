// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLandmarks.h"

#include "dggBucketSearch.h"
#include "dggDisjointSets.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dgg
{
namespace
{
constexpr std::int16_t LargestCode = std::numeric_limits<std::int16_t>::max();
/// Bound of the rounding error of the distances themselves, in steps; far larger than necessary.
constexpr double RoundingOfSteps = 1e-6;
/// Progress weight, within the choice, of each of the two full searches.
constexpr double SearchShare = 0.15;
/// Components smaller than this fraction of the surface (inverse) are searched without landmarks.
constexpr Id SmallestShare = 2 * Landmarks::Count;

/// Distances from the nearest of incrementally added vertices.
class GrowingField
{
public:
  GrowingField(const GraphView& graph, const GraphFans* fans, double bucketWidth)
    : Graph(graph)
    , Fans(fans)
    , BucketWidth(bucketWidth)
    , Labels(this->Distances, this->Origins, this->Touched, std::numeric_limits<double>::max())
  {
  }

  /// Starts with the given vertices only. Returns false if aborted.
  bool Start(const std::vector<Id>& vertices, const ProgressCallback& progress)
  {
    std::vector<GraphSeed> seeds;
    for (const Id v : vertices)
    {
      seeds.emplace_back();
      seeds.back().Vertex = v;
    }
    this->Labels.Start(this->Graph.NumberOfVertices, seeds);
    SearchEffort effort;
    return RunBucketSearch(this->Graph, this->Fans, seeds, this->BucketWidth, progress, this->Queue,
      this->Labels, effort);
  }

  /// Adds a vertex; only visits the region where it is nearest. Not certified.
  void Add(Id v)
  {
    std::vector<GraphSeed> seeds(1);
    seeds[0].Vertex = v;
    this->Labels.Lower(seeds[0], 0);
    if (this->Fans)
    {
      RunAlongFans(
        this->Graph, *this->Fans, seeds, this->BucketWidth, this->Queue, this->Labels, this->Order);
      return;
    }
    SearchEffort effort;
    RunBucketSearch(
      this->Graph, nullptr, seeds, this->BucketWidth, nullptr, this->Queue, this->Labels, effort);
  }

  /// Returns the distance of a vertex; 0 if unreached.
  double GetDistance(Id v) const { return this->Labels.IsReached(v) ? this->Distances[v] : 0.0; }

  Id FindFarthest() const
  {
    Id farthest = 0;
    for (Id v = 1; v < this->Graph.NumberOfVertices; ++v)
    {
      farthest = this->GetDistance(v) > this->GetDistance(farthest) ? v : farthest;
    }
    return farthest;
  }

private:
  const GraphView& Graph;
  const GraphFans* Fans;
  double BucketWidth;
  std::vector<double> Distances;
  std::vector<LabelOrigin> Origins;
  std::vector<Id> Touched;
  std::vector<Id> Order;
  SearchLabels Labels;
  BucketQueue Queue;
};

std::int16_t Clamp(double code)
{
  return static_cast<std::int16_t>(std::max(0.0, std::min<double>(code, LargestCode)));
}
}

Status Landmarks::Choose(const GraphView& graph, const GraphFans* fans, double bucketWidth,
  const ProgressCallback& progress)
{
  const auto report = [&](double fraction) { return !progress || progress(fraction); };
  this->Codes.resize(graph.NumberOfVertices);
  const bool isDone = report(0.0) &&
    this->ChooseFrom(graph, fans, bucketWidth, this->ChooseComponents(graph), report) &&
    report(1.0);
  return isDone ? Status::Success() : Status::Abort();
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

/// Chooses landmarks in the components of `starts`. Returns false if aborted.
bool Landmarks::ChooseFrom(const GraphView& graph, const GraphFans* fans, double bucketWidth,
  const std::vector<Id>& starts, const ProgressCallback& progress)
{
  if (starts.empty())
  {
    return true;
  }
  // The first landmark of a component is a tip: the vertex farthest from an arbitrary vertex.
  GrowingField field(graph, fans, bucketWidth);
  if (!field.Start(starts, ProgressPart(progress, 0.0, SearchShare)))
  {
    return false;
  }
  for (const Id start : starts)
  {
    Id tip = start;
    for (Id v = 0; v < graph.NumberOfVertices; ++v)
    {
      const bool isFarther = field.GetDistance(v) > field.GetDistance(tip);
      tip = isFarther && this->AreConnected(v, start) ? v : tip;
    }
    this->Vertices.push_back(tip);
  }
  if (!field.Start(this->Vertices, ProgressPart(progress, SearchShare, 2.0 * SearchShare)))
  {
    return false;
  }
  Id farthest = field.FindFarthest();
  // Distances larger than that between two tips are clamped; the difference of clamped distances is
  // still at most the distance between two vertices.
  this->Step = field.GetDistance(farthest) / LargestCode;
  while (this->Vertices.size() < Count && field.GetDistance(farthest) > 0.0)
  {
    const double done = static_cast<double>(this->Vertices.size()) / Count;
    if (!progress(2.0 * SearchShare + (1.0 - 2.0 * SearchShare) * done))
    {
      return false;
    }
    this->Vertices.push_back(farthest);
    field.Add(farthest);
    farthest = field.FindFarthest();
  }
  return true;
}

void Landmarks::SetDistances(std::size_t k, const double* distances)
{
  const double perStep = 1.0 / this->Step;
  for (std::size_t v = 0; v < this->Codes.size(); ++v)
  {
    // 0 in other components: there the differences carry no information, but remain valid bounds.
    this->Codes[v][k] = distances[v] < Infinity ? Clamp(distances[v] * perStep) : 0;
  }
}

void Landmarks::Aim(const std::vector<GraphSeed>& seeds, Goal& goal) const
{
  goal.Low.fill(0);
  goal.High.fill(LargestCode);
  for (std::size_t k = 0; k < this->Vertices.size(); ++k)
  {
    // In steps; a code c represents distances in [c, c + 1].
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
