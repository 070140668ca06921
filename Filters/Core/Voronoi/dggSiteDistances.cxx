// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSiteDistances.h"

#include "dggFartherSites.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>

namespace dgg
{
namespace
{
/// Progress weight of the search for the nearest sites.
constexpr double NearestShare = 0.5;
}

std::vector<std::size_t> ListDistinctSeeds(
  const std::vector<GraphSeed>& seeds, const std::vector<Offset>& points)
{
  using Place = std::vector<std::pair<Offset, double>>;
  std::map<Id, Place> places;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    places[seeds[i].Source].emplace_back(points[i], seeds[i].Distance);
  }
  std::map<Place, Id> first;
  for (auto& place : places)
  {
    std::sort(place.second.begin(), place.second.end());
    first.emplace(place.second, place.first);
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    if (first.find(places[seeds[i].Source])->second == seeds[i].Source)
    {
      kept.push_back(i);
    }
  }
  return kept;
}

Status SiteDistances::Run(const GraphSearch& search, const SurfaceMesh& mesh,
  const std::vector<GraphSeed>& seeds, const ProgressCallback& progress)
{
  std::vector<Offset> vertices;
  for (const GraphSeed& seed : seeds)
  {
    vertices.push_back(seed.Vertex);
  }
  std::vector<GraphSeed> kept;
  for (const std::size_t i : ListDistinctSeeds(seeds, vertices))
  {
    kept.push_back(seeds[i]);
  }
  SearchOptions options;
  options.Correct = true;
  options.Progress = ProgressPart(progress, 0.0, NearestShare);
  SearchResult found;
  DGG_RETURN_IF_ERROR(search.Run(kept, options, found));
  const GraphView& graph = search.GetGraph();
  std::unique_ptr<const LabelCorrection> correction;
  if (graph.Angles && graph.ArrivalAngles)
  {
    correction = std::make_unique<const LabelCorrection>(graph, mesh);
  }
  NearestSites nearest;
  std::vector<double> limits = MeasureReach(mesh);
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    nearest.Sites.push_back(found.Seeds[v] == NoId ? NoId : kept[found.Seeds[v]].Source);
    limits[v] = LimitOfLabel(graph.Info, found.Distances[v], limits[v]);
  }
  nearest.Distances = found.Corrected.empty() ? found.Distances : std::move(found.Corrected);
  nearest.Labels = std::move(found.Distances);
  nearest.Sources = std::move(found.Virtual);
  nearest.Sources.resize(nearest.Labels.size());
  FartherSites farther(graph, correction.get(), nearest, kept, std::move(limits));
  DGG_RETURN_IF_ERROR(farther.Run(ProgressPart(progress, NearestShare, 1.0)));
  for (const Id label : farther.GetSettled())
  {
    farther.Estimate(label);
  }
  ValueLists<Entry> entries;
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    AddList(nearest, farther, v, entries);
  }
  this->Set(correction != nullptr, std::move(entries));
  return Status::Success();
}

void SiteDistances::Set(bool hasVirtualSources, ValueLists<Entry> entries)
{
  this->HasDirections = hasVirtualSources;
  this->Entries = std::move(entries);
}

void SiteDistances::AddList(
  const NearestSites& nearest, const FartherSites& farther, Id v, ValueLists<Entry>& entries)
{
  if (nearest.Sites[v] != NoId)
  {
    entries.Values.push_back({ nearest.Sites[v], nearest.Distances[v], nearest.Sources[v] });
    farther.ForEach(v, [&](Id site, const LabelCorrection::Estimate& estimate) {
      entries.Values.push_back({ site, estimate.Distance, estimate.Source });
    });
    std::sort(entries.Values.begin() + entries.Begins.back(), entries.Values.end(),
      [](const Entry& a, const Entry& b) { return a.Site < b.Site; });
  }
  entries.EndList();
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
