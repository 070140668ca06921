// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggManySources.h"

#include "dggPrefetch.h"
#include "dggSearchLabels.h"

#include <algorithm>
#include <limits>

namespace dgg
{
namespace
{
/// Key of a vertex that is not in the queue.
constexpr float NotWaiting = std::numeric_limits<float>::infinity();
/// Number of vertices by which edges are prefetched in a sweep.
constexpr std::size_t RowLookahead = 4;
/// Number of edges by which the labels at their ends are prefetched.
constexpr Offset LabelLookahead = 8;
/// Number of sweeps of the near field in both directions. More sweeps leave fewer labels to
/// correct, but cost more.
constexpr int NearFieldRounds = 2;
}

ManySources::ManySources(const GraphView& graph, double bucketWidth)
  : Graph(graph)
  , BucketWidth(bucketWidth)
{
}

bool ManySources::Run(const Sources& sources, double radius, const SweepOrder& order,
  const std::function<bool()>& shouldContinue)
{
  const auto n = static_cast<std::size_t>(this->Graph.NumberOfVertices);
  this->Radius = radius;
  this->Labels.assign(n, Lanes());
  this->Keys.assign(n, NotWaiting);
  this->Queue.Reset(this->Start(sources), this->BucketWidth);
  bool isDone = false;
  WithLengths(this->Graph, [&](const auto* lengths) {
    this->SweepNearField(lengths, order);
    if (!shouldContinue())
    {
      return;
    }
    this->Sweep(lengths, order.Vertices);
    if (!shouldContinue())
    {
      return;
    }
    this->Certify(lengths);
    if (!shouldContinue())
    {
      return;
    }
    this->Mend(lengths);
    isDone = true;
  });
  return isDone;
}

void ManySources::GetField(
  std::size_t k, std::vector<double>& field, std::vector<Id>& reached) const
{
  field.resize(this->Labels.size());
  reached.clear();
  for (std::size_t v = 0; v < field.size(); ++v)
  {
    const double label = this->Labels[v].Get(static_cast<int>(k));
    const bool isReached = label <= this->Radius && label < Infinity;
    field[v] = isReached ? label : Infinity;
    if (isReached)
    {
      reached.push_back(static_cast<Id>(v));
    }
  }
}

/// Sets the labels of the seeds. Returns the smallest label.
double ManySources::Start(const Sources& sources)
{
  double smallest = Infinity;
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    for (const GraphSeed& seed : *sources[k])
    {
      const auto lane = static_cast<int>(k);
      Lanes& labels = this->Labels[seed.Vertex];
      labels.Set(lane, std::min(labels.Get(lane), seed.Distance));
      smallest = std::min(smallest, seed.Distance);
    }
  }
  return smallest;
}

/// Sweeps the near field in both directions, since the sources lie on all sides. Errors in the near
/// field would propagate to all vertices.
template <typename Length>
void ManySources::SweepNearField(const Length* lengths, const SweepOrder& order)
{
  const auto begin = order.Vertices.begin();
  const std::vector<Id> there(begin, begin + static_cast<std::ptrdiff_t>(order.NearField));
  const std::vector<Id> back(there.rbegin(), there.rend());
  for (int round = 0; round < NearFieldRounds; ++round)
  {
    this->Sweep(lengths, there);
    this->Sweep(lengths, back);
  }
}

template <typename Length>
void ManySources::Sweep(const Length* lengths, const std::vector<Id>& order)
{
  constexpr Offset cacheLine = 16;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i + RowLookahead < order.size())
    {
      const Id ahead = order[i + RowLookahead];
      for (Offset e = this->Graph.Offsets[ahead]; e < this->Graph.Offsets[ahead + 1];
           e += cacheLine)
      {
        Prefetch(this->Graph.Targets + e);
        Prefetch(lengths + e);
      }
    }
    this->Labels[order[i]] = this->Pull(lengths, order[i]);
  }
}

/// Searches for a shorter path to every vertex. Few vertices have one.
template <typename Length>
void ManySources::Certify(const Length* lengths)
{
  for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
  {
    this->Lower(v, this->Pull(lengths, v));
  }
}

/// Propagates lowered labels to neighbors.
template <typename Length>
void ManySources::Mend(const Length* lengths)
{
  const auto isOutdated = [this](const BucketQueue::Entry& entry) {
    return entry.Key != this->Keys[entry.Vertex];
  };
  while (this->Queue.Advance())
  {
    this->Queue.Sift(isOutdated);
    const std::vector<BucketQueue::Entry>& bucket = this->Queue.Current();
    // NOLINTNEXTLINE(modernize-loop-convert): the bucket grows during the loop
    for (std::size_t i = 0; i < bucket.size(); ++i)
    {
      if (!isOutdated(bucket[i]))
      {
        const Id v = bucket[i].Vertex;
        this->Keys[v] = NotWaiting;
        this->Push(lengths, v);
      }
    }
    this->Queue.ClearCurrent();
  }
}

/// Returns the labels of the shortest paths to a vertex through its neighbors. Edges have the same
/// length in both directions.
template <typename Length>
Lanes ManySources::Pull(const Length* lengths, Id v) const
{
  Lanes labels = this->Labels[v];
  const Offset end = this->Graph.Offsets[v + 1];
  for (Offset e = this->Graph.Offsets[v]; e < end; ++e)
  {
    Prefetch(&this->Labels[this->Graph.Targets[std::min(e + LabelLookahead, end - 1)]]);
    labels.Pull(this->Labels[this->Graph.Targets[e]], lengths[e]);
  }
  return labels;
}

template <typename Length>
void ManySources::Push(const Length* lengths, Id v)
{
  const Lanes from = this->Labels[v];
  for (Offset e = this->Graph.Offsets[v]; e < this->Graph.Offsets[v + 1]; ++e)
  {
    const Id t = this->Graph.Targets[e];
    Lanes labels = this->Labels[t];
    labels.Pull(from, lengths[e]);
    this->Lower(t, labels);
  }
}

/// Stores labels, none of which exceeds the present one. If some labels are lower, the vertex is
/// queued.
void ManySources::Lower(Id v, const Lanes& labels)
{
  if (!labels.AreBelow(this->Labels[v]))
  {
    return;
  }
  const double smallest = labels.SmallestBelow(this->Labels[v]);
  this->Labels[v] = labels;
  const float key = this->Queue.Key(smallest);
  if (smallest <= this->Radius && key < this->Keys[v])
  {
    this->Keys[v] = key;
    this->Queue.Push(smallest, v);
  }
}
}
