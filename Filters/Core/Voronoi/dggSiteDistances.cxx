// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSiteDistances.h"

#include "dggHeap.h"
#include "dggLabelCorrection.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>

namespace dgg
{
namespace
{
/// Progress weight of the search for the nearest sites.
constexpr double NearestShare = 0.5;
/// Labels between two progress reports.
constexpr std::size_t ProgressInterval = 16384;
/// Number of passes in which the reach of a vertex becomes the maximum over its neighborhood,
/// because paths may pass vertices whose own faces are smaller.
constexpr int ReachRounds = 1;
/// Number of labels of a vertex from which on a hash table replaces linear search: on faces that
/// are large compared to cells, vertices have hundreds of sites.
constexpr Id LongList = 12;

/// A distance from a site other than the nearest one.
struct Label
{
  double Distance;
  LabelCorrection::Estimate Estimate;
  Offset Edge; ///< edge to the vertex; -1 for a seed
  Id Site;
  Id Vertex;
  Id Tail;      ///< tail of the edge; index of the seed if there is no edge
  Id TailLabel; ///< label at the tail; NoId for the label of the nearest site
  Id Next;      ///< next label of the same vertex, or NoId
};

/// Returns the seeds without seeds of duplicate sites.
std::vector<GraphSeed> WithoutDuplicates(const std::vector<GraphSeed>& seeds)
{
  using Place = std::vector<std::pair<Id, double>>;
  std::map<Id, Place> places;
  for (const GraphSeed& seed : seeds)
  {
    places[seed.Source].emplace_back(seed.Vertex, seed.Distance);
  }
  std::map<Place, Id> first;
  for (auto& place : places)
  {
    std::sort(place.second.begin(), place.second.end());
    first.emplace(place.second, place.first);
  }
  std::vector<GraphSeed> kept;
  for (const GraphSeed& seed : seeds)
  {
    if (first.find(places[seed.Source])->second == seed.Source)
    {
      kept.push_back(seed);
    }
  }
  return kept;
}

/// Returns the longest edge of the faces around each vertex and its neighbors.
std::vector<double> MeasureReach(const SurfaceMesh& mesh)
{
  std::vector<double> reach(mesh.GetNumberOfVertices(), 0.0);
  for (int round = 0; round <= ReachRounds; ++round)
  {
    const std::vector<double> before = reach;
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      if (mesh.IsDropped(f))
      {
        continue;
      }
      double largest = 0.0;
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        largest = std::max(largest, std::max(before[mesh.Origin(h)], mesh.Length(h)));
      }
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        reach[mesh.Origin(h)] = std::max(reach[mesh.Origin(h)], largest);
      }
    }
  }
  return reach;
}

/// Computes the labels of sites other than the nearest.
class FartherSites
{
public:
  FartherSites(const GraphView& graph, const SurfaceMesh& mesh, const std::vector<GraphSeed>& seeds,
    const SearchResult& nearest)
    : Graph(graph)
    , Seeds(seeds)
    , Nearest(nearest)
    , Heads(graph.NumberOfVertices, NoId)
    , Limits(MeasureReach(mesh))
    , Counts(graph.NumberOfVertices, 0)
  {
    if (graph.Angles && graph.ArrivalAngles)
    {
      this->Correction = std::make_unique<LabelCorrection>(graph, mesh);
    }
    for (Id v = 0; v < graph.NumberOfVertices; ++v)
    {
      // Labels exceed distances by up to the accuracy.
      this->Limits[v] = nearest.Distances[v] * (1.0 + graph.Info.Accuracy) + 2.0 * this->Limits[v];
    }
  }

  Status Run(const ProgressCallback& progress)
  {
    this->Start();
    std::size_t pops = 0;
    while (!this->Heap.IsEmpty())
    {
      const MinimumHeap::Entry top = this->Heap.Pop();
      const Id index = top.Index;
      if (top.Key > this->Labels[index].Distance) // the label has been lowered since
      {
        continue;
      }
      if (++pops % ProgressInterval == 0)
      {
        DGG_RETURN_IF_ERROR(ReportTo(progress, NearestShare));
      }
      this->Finish(index);
      this->Relax(this->Labels[index].Vertex, this->Labels[index].Site, top.Key, index);
    }
    return Status::Success();
  }

  /// Calls `use(site, estimate)` for the labels of a vertex, in no particular order.
  template <typename Use>
  void ForEach(Id v, const Use& use) const
  {
    for (Id i = this->Heads[v]; i != NoId; i = this->Labels[i].Next)
    {
      use(this->Labels[i].Site, this->Labels[i].Estimate);
    }
  }

private:
  Id SiteOf(Id v) const
  {
    const Id seed = this->Nearest.Seeds[v];
    return seed == NoId ? NoId : this->Seeds[seed].Source;
  }

  /// Creates all labels that follow from the labels of the nearest sites.
  void Start()
  {
    for (std::size_t i = 0; i < this->Seeds.size(); ++i)
    {
      const GraphSeed& seed = this->Seeds[i];
      this->Offer(seed.Vertex, seed.Source, seed.Distance, -1, static_cast<Id>(i), NoId);
    }
    for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
    {
      const Id site = this->SiteOf(v);
      if (site != NoId)
      {
        this->Relax(v, site, this->Nearest.Distances[v], NoId);
      }
    }
  }

  void Relax(Id v, Id site, double distance, Id label)
  {
    for (Offset e = this->Graph.Offsets[v]; e < this->Graph.Offsets[v + 1]; ++e)
    {
      this->Offer(this->Graph.Targets[e], site, distance + this->Graph.Length(e), e, v, label);
    }
  }

  static std::uint64_t Key(Id v, Id site)
  {
    return (static_cast<std::uint64_t>(v) << 32) | static_cast<std::uint32_t>(site);
  }

  /// Returns the label of a vertex for a site; NoId if there is none.
  Id Find(Id v, Id site) const
  {
    if (this->Counts[v] >= LongList)
    {
      const auto place = this->Places.find(Key(v, site));
      return place == this->Places.end() ? NoId : place->second;
    }
    Id index = this->Heads[v];
    while (index != NoId && this->Labels[index].Site != site)
    {
      index = this->Labels[index].Next;
    }
    return index;
  }

  void Offer(Id v, Id site, double distance, Offset edge, Id tail, Id tailLabel)
  {
    if (!(distance <= this->Limits[v]) || this->SiteOf(v) == site)
    {
      return;
    }
    Id index = this->Find(v, site);
    if (index == NoId)
    {
      index = static_cast<Id>(this->Labels.size());
      this->Labels.push_back({ Infinity, {}, edge, site, v, tail, tailLabel, this->Heads[v] });
      this->Heads[v] = index;
      if (++this->Counts[v] == LongList)
      {
        for (Id i = index; i != NoId; i = this->Labels[i].Next)
        {
          this->Places.emplace(Key(v, this->Labels[i].Site), i);
        }
      }
      else if (this->Counts[v] > LongList)
      {
        this->Places.emplace(Key(v, site), index);
      }
    }
    Label& label = this->Labels[index];
    if (distance < label.Distance)
    {
      label.Distance = distance;
      label.Edge = edge;
      label.Tail = tail;
      label.TailLabel = tailLabel;
      this->Heap.Push(distance, index);
    }
  }

  /// Computes the estimate of a final label, whose tail is finished.
  void Finish(Id index)
  {
    Label& label = this->Labels[index];
    if (!this->Correction)
    {
      label.Estimate.Distance = label.Distance;
    }
    else if (label.Edge < 0)
    {
      label.Estimate = LabelCorrection::EstimateOf(this->Seeds[label.Tail]);
    }
    else
    {
      const Id u = label.Tail;
      const LabelCorrection::Estimate tail = label.TailLabel != NoId
        ? this->Labels[label.TailLabel].Estimate
        : LabelCorrection::Estimate{ this->Nearest.Virtual[u], this->Nearest.Corrected[u] };
      label.Estimate =
        this->Correction->Extend({ label.Edge, label.Vertex, u }, label.Distance, tail, 0.0);
    }
  }

  const GraphView& Graph;
  const std::vector<GraphSeed>& Seeds;
  const SearchResult& Nearest;
  std::unique_ptr<LabelCorrection> Correction; ///< null where there are no angles
  std::vector<Id> Heads;                       ///< per vertex, its first label
  std::vector<double> Limits;                  ///< per vertex, upper limit of relevant labels
  std::vector<Label> Labels;
  std::vector<Id> Counts; ///< per vertex, number of its labels
  std::unordered_map<std::uint64_t, Id>
    Places;         ///< hash table of the labels of vertices with many labels
  MinimumHeap Heap; ///< queue of labels
};
}

Status SiteDistances::Run(const GraphSearch& search, const SurfaceMesh& mesh,
  const std::vector<GraphSeed>& seeds, const ProgressCallback& progress)
{
  this->Offsets.clear();
  this->Entries.clear();
  const std::vector<GraphSeed> kept = WithoutDuplicates(seeds);
  SearchOptions options;
  options.Correct = true;
  options.Progress = ProgressPart(progress, 0.0, NearestShare);
  SearchResult nearest;
  DGG_RETURN_IF_ERROR(search.Run(kept, options, nearest));
  this->HasDirections = !nearest.Corrected.empty();
  if (!this->HasDirections)
  {
    nearest.Corrected = nearest.Distances;
    nearest.Virtual.resize(nearest.Distances.size());
  }
  const GraphView& graph = search.GetGraph();
  FartherSites farther(graph, mesh, kept, nearest);
  DGG_RETURN_IF_ERROR(farther.Run(progress));
  this->Offsets.push_back(0);
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    if (nearest.Seeds[v] != NoId)
    {
      this->Entries.push_back(
        { kept[nearest.Seeds[v]].Source, nearest.Corrected[v], nearest.Virtual[v] });
      farther.ForEach(v, [this](Id site, const LabelCorrection::Estimate& estimate) {
        this->Entries.push_back({ site, estimate.Distance, estimate.Source });
      });
      std::sort(this->Entries.begin() + this->Offsets.back(), this->Entries.end(),
        [](const Entry& a, const Entry& b) { return a.Site < b.Site; });
    }
    this->Offsets.push_back(static_cast<Offset>(this->Entries.size()));
  }
  return Status::Success();
}

const SiteDistances::Entry* SiteDistances::Find(Id v, Id site) const
{
  const Entry* entry = std::lower_bound(
    this->Begin(v), this->End(v), site, [](const Entry& e, Id number) { return e.Site < number; });
  return entry != this->End(v) && entry->Site == site ? entry : nullptr;
}

const SiteDistances::Entry* SiteDistances::Nearest(Id v) const
{
  const Entry* nearest = nullptr;
  for (const Entry* entry = this->Begin(v); entry != this->End(v); ++entry)
  {
    nearest = !nearest || entry->Distance < nearest->Distance ? entry : nearest;
  }
  return nearest;
}
}
