// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggManySources.h"

#include "dggPrefetch.h"
#include "dggSearchLabels.h"

namespace dgg
{
namespace
{
/// How many queue entries ahead the memory of a vertex is asked for.
constexpr std::size_t Lookahead = 4;
constexpr float NotPending = std::numeric_limits<float>::infinity();
}

ManySources::ManySources(const GraphView& graph, double bucketWidth)
  : Graph(graph)
  , BucketWidth(bucketWidth)
{
}

void ManySources::Run(const Id* sources, int count, double radius, double* const* rows)
{
  const auto n = static_cast<std::size_t>(this->Graph.NumberOfVertices);
  this->Radius = radius;
  this->Labels.assign(n, Lanes::Unreached());
  this->Pending.assign(n, NotPending);
  this->Queue.Reset(0.0, this->BucketWidth);
  for (int k = 0; k < count && radius >= 0.0; ++k)
  {
    this->Labels[sources[k]].Values[k] = 0.0;
    this->Enter(sources[k], 0.0);
  }
  WithLengths(this->Graph, [&](const auto* lengths) { this->Propagate(lengths); });
  for (std::size_t v = 0; v < n; ++v)
  {
    for (int k = 0; k < count; ++k)
    {
      const double label = this->Labels[v].Values[k];
      rows[k][v] = label <= radius ? label : Infinity;
    }
  }
}

template <typename Length>
void ManySources::Propagate(const Length* lengths)
{
  while (this->Queue.Advance())
  {
    const std::vector<BucketQueue::Entry>& bucket = this->Queue.Current();
    for (std::size_t i = 0; i < bucket.size(); ++i)
    {
      if (i + Lookahead < bucket.size())
      {
        const Id next = bucket[i + Lookahead].Vertex;
        Prefetch(&this->Labels[next]);
        Prefetch(this->Graph.Targets + this->Graph.Offsets[next]);
        Prefetch(lengths + this->Graph.Offsets[next]);
      }
      const Id v = bucket[i].Vertex;
      if (bucket[i].Key > this->Pending[v]) // it was entered again with a smaller label
      {
        continue;
      }
      this->Pending[v] = NotPending;
      const Lanes labels = this->Labels[v];
      const Offset end = this->Graph.Offsets[v + 1];
      for (Offset e = this->Graph.Offsets[v]; e < end; ++e)
      {
        Lanes& others = this->Labels[this->Graph.Targets[e]];
        if (labels.Lowers(lengths[e], others))
        {
          this->Enter(this->Graph.Targets[e], labels.Lower(lengths[e], others));
        }
      }
    }
    this->Queue.ClearCurrent();
  }
}

/// Have a vertex relaxed whose label was lowered to `label`.
void ManySources::Enter(Id v, double label)
{
  const float key = this->Queue.Key(label);
  if (label <= this->Radius && key < this->Pending[v])
  {
    this->Pending[v] = key;
    this->Queue.Push(label, v);
  }
}
}
