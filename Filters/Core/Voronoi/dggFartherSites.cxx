// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFartherSites.h"

#include "dggProgressPart.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace dgg
{
namespace
{
/// Labels between two progress reports.
constexpr std::size_t ProgressInterval = 16384;
/// Number of passes in which the reach of a vertex becomes the maximum over its neighborhood.
constexpr int ReachRounds = 1;
/// Number of labels of a vertex from which on a hash table replaces linear search: on faces that
/// are large compared to cells, vertices have hundreds of sites.
constexpr Id LongList = 12;

std::uint64_t Key(Id v, Id site)
{
  return (static_cast<std::uint64_t>(v) << 32) | static_cast<std::uint32_t>(site);
}
}

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

FartherSites::FartherSites(const GraphView& graph, const LabelCorrection* correction,
  const NearestSites& nearest, const std::vector<GraphSeed>& seeds, std::vector<double> limits,
  const Offset* ids)
  : Graph(graph)
  , Correction(correction)
  , Nearest(nearest)
  , Seeds(seeds)
  , Ids(ids)
  , Heads(graph.NumberOfVertices, NoId)
  , Limits(std::move(limits))
  , Counts(graph.NumberOfVertices, 0)
{
}

Status FartherSites::Run(const ProgressCallback& progress)
{
  this->Settled.clear();
  if (!this->IsStarted)
  {
    this->Start();
  }
  while (!this->Heap.IsEmpty())
  {
    const MinimumHeap::Entry top = this->Heap.Pop();
    const Id index = top.Index;
    if (top.Key > this->Labels[index].Distance) // the label has been lowered since
    {
      continue;
    }
    this->Settled.push_back(index);
    if (this->Settled.size() % ProgressInterval == 0)
    {
      DGG_RETURN_IF_ERROR(ReportTo(progress, 0.0));
    }
    this->Relax(this->Labels[index].Vertex, this->Labels[index].Site, top.Key, index);
  }
  return Status::Success();
}

/// Creates all labels that follow from seeds and from the labels of the nearest sites.
void FartherSites::Start()
{
  this->IsStarted = true;
  for (std::size_t i = 0; i < this->Seeds.size(); ++i)
  {
    const GraphSeed& seed = this->Seeds[i];
    this->Offer(seed.Vertex, seed.Source, seed.Distance, -1, static_cast<Id>(i), NoId);
  }
  for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
  {
    if (this->Nearest.Sites[v] != NoId)
    {
      this->Relax(v, this->Nearest.Sites[v], this->Nearest.Labels[v], NoId);
    }
  }
}

void FartherSites::Relax(Id v, Id site, double distance, Id label)
{
  for (Offset e = this->Graph.Offsets[v]; e < this->Graph.Offsets[v + 1]; ++e)
  {
    this->Offer(this->Graph.Targets[e], site, distance + this->Graph.Length(e), e, v, label);
  }
}

void FartherSites::Offer(Id v, Id site, double distance, Offset edge, Id tail, Id tailLabel)
{
  if (!(distance <= this->Limits[v]) || this->Nearest.Sites[v] == site)
  {
    return;
  }
  const Id index = this->FindOrAdd(v, site);
  Label& label = this->Labels[index];
  const bool isLower = distance < label.Distance;
  if (isLower || (distance == label.Distance && this->IsPreferred(label, edge, tail, tailLabel)))
  {
    label.Distance = distance;
    label.Edge = edge;
    label.Tail = tail;
    label.TailLabel = tailLabel;
  }
  if (isLower)
  {
    this->Heap.Push(distance, index);
  }
}

/// Returns true if a path of equal length replaces the path of a label.
bool FartherSites::IsPreferred(const Label& present, Offset edge, Id tail, Id tailLabel) const
{
  if (edge < 0 || present.Edge < 0 ||
    !(this->Ids ? this->Ids[tail] < this->Ids[present.Tail] : tail < present.Tail))
  {
    return false;
  }
  const double label =
    tailLabel == NoId ? this->Nearest.Labels[tail] : this->Labels[tailLabel].Distance;
  return label < present.Distance;
}

void FartherSites::Receive(Id v, Id site, double distance)
{
  const Id index = this->FindOrAdd(v, site);
  if (distance < this->Labels[index].Distance)
  {
    this->Labels[index].Distance = distance;
    this->Heap.Push(distance, index);
  }
}

void FartherSites::ReceiveEstimate(Id v, Id site, const LabelCorrection::Estimate& estimate)
{
  this->Labels[this->FindOrAdd(v, site)].Estimate = estimate;
}

/// Returns the label of a vertex for a site; NoId if there is none.
Id FartherSites::Find(Id v, Id site) const
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

/// Returns the label of a vertex for a site, which is infinite if it is new.
Id FartherSites::FindOrAdd(Id v, Id site)
{
  Id index = this->Find(v, site);
  if (index != NoId)
  {
    return index;
  }
  index = static_cast<Id>(this->Labels.size());
  this->Labels.push_back({ Infinity, { {}, Infinity }, -1, site, v, NoId, NoId, this->Heads[v] });
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
  return index;
}

bool FartherSites::Estimate(Id index)
{
  Label& label = this->Labels[index];
  if (!this->Correction)
  {
    label.Estimate.Distance = label.Distance;
    return true;
  }
  if (label.Edge < 0)
  {
    label.Estimate = LabelCorrection::EstimateOf(this->Seeds[label.Tail]);
    return true;
  }
  const LabelCorrection::Estimate tail = label.TailLabel != NoId
    ? this->Labels[label.TailLabel].Estimate
    : this->Nearest.GetEstimate(label.Tail);
  if (tail.Distance == Infinity)
  {
    return false;
  }
  label.Estimate =
    this->Correction->Extend({ label.Edge, label.Vertex, label.Tail }, label.Distance, tail, 0.0);
  return true;
}
}
