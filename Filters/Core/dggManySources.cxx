// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggManySources.h"

#include "dggPrefetch.h"
#include "dggSearchLabels.h"

#include <cmath>

namespace dgg
{
namespace
{
/// How many queue entries ahead the memory of a vertex, its edges and its neighbours is asked for.
constexpr std::size_t VertexLookahead = 12;
constexpr std::size_t EdgesLookahead = 6;
constexpr std::size_t NeighborsLookahead = 3;
/// How many edges ahead, when all are certified.
constexpr Offset EdgeLookahead = 12;
/// Waves that arrive from directions this close share a fan, in units of its half width.
constexpr float SharedPart = 0.4f;
}

ManySources::ManySources(const GraphView& graph, const GraphFans* fans, double bucketWidth)
  : Graph(graph)
  , Fans(fans)
  , BucketWidth(bucketWidth)
{
}

void ManySources::Run(const Id* sources, int count, double radius, double* const* rows)
{
  const auto n = static_cast<std::size_t>(this->Graph.NumberOfVertices);
  this->Radius = radius;
  this->Vertices.assign(n, Vertex());
  this->Queue.Reset(0.0, this->BucketWidth);
  for (int k = 0; k < count && radius >= 0.0; ++k)
  {
    Vertex& vertex = this->Vertices[sources[k]];
    vertex.Labels.Values[k] = 0.0;
    vertex.Arrivals[k] = -1.0f;
    vertex.New |= 1u << k;
    vertex.Key = this->Queue.Key(0.0);
    this->Queue.Push(0.0, sources[k]);
  }
  WithLengths(this->Graph, [&](const auto* lengths) {
    this->Propagate(lengths, this->Fans);
    if (this->Fans)
    {
      this->Certify(lengths);
      this->Propagate(lengths, nullptr);
    }
  });
  for (std::size_t v = 0; v < n; ++v)
  {
    for (int k = 0; k < count; ++k)
    {
      const double label = this->Vertices[v].Labels.Values[k];
      rows[k][v] = label <= radius ? label : Infinity;
    }
  }
}

template <typename Length>
void ManySources::Propagate(const Length* lengths, const GraphFans* fans)
{
  const auto isOutdated = [this](const BucketQueue::Entry& entry) {
    return entry.Key != this->Vertices[entry.Vertex].Key;
  };
  while (this->Queue.Advance())
  {
    this->Queue.Sift(isOutdated);
    const std::vector<BucketQueue::Entry>& bucket = this->Queue.Current();
    for (std::size_t i = 0; i < bucket.size(); ++i)
    {
      this->LookAhead(lengths, fans, i);
      if (isOutdated(bucket[i]))
      {
        continue;
      }
      const Id v = bucket[i].Vertex;
      Vertex& vertex = this->Vertices[v];
      const std::uint32_t lanes = vertex.New;
      vertex.Key = NotWaiting;
      vertex.New = 0;
      if (fans)
      {
        this->RelaxFans(lengths, *fans, v, lanes);
        continue;
      }
      const Lanes labels = vertex.Labels;
      for (Offset e = this->Graph.Offsets[v]; e < this->Graph.Offsets[v + 1]; ++e)
      {
        this->Relax(lengths, labels, e);
      }
    }
    this->Queue.ClearCurrent();
  }
}

/// Ask for the memory that vertices further back in the queue will need.
template <typename Length>
void ManySources::LookAhead(const Length* lengths, const GraphFans* fans, std::size_t i) const
{
  if (const BucketQueue::Entry* entry = this->Queue.LookAhead(i, VertexLookahead))
  {
    const Vertex& vertex = this->Vertices[entry->Vertex];
    Prefetch(&vertex.Labels);
    Prefetch(&vertex.Arrivals);
    if (fans)
    {
      fans->PrefetchVertex(entry->Vertex);
    }
  }
  const BucketQueue::Entry* edges = fans ? this->Queue.LookAhead(i, EdgesLookahead) : nullptr;
  if (edges && this->Vertices[edges->Vertex].New != 0)
  {
    const Vertex& vertex = this->Vertices[edges->Vertex];
    fans->PrefetchFan(this->Graph, lengths, edges->Vertex, vertex.Arrivals[LowestBit(vertex.New)]);
  }
  const BucketQueue::Entry* neighbors =
    fans ? this->Queue.LookAhead(i, NeighborsLookahead) : nullptr;
  if (neighbors && this->Vertices[neighbors->Vertex].New != 0)
  {
    const Vertex& vertex = this->Vertices[neighbors->Vertex];
    fans->ForEach(neighbors->Vertex, vertex.Arrivals[LowestBit(vertex.New)], [this](Offset e) {
      const Vertex& neighbor = this->Vertices[this->Graph.Targets[e]];
      Prefetch(&neighbor.Labels);
      Prefetch(&neighbor.Arrivals);
    });
  }
}

/// The labels that are new, over the fans of the directions from which they came. Those that came
/// from about the same direction go together.
template <typename Length>
void ManySources::RelaxFans(const Length* lengths, const GraphFans& fans, Id v, std::uint32_t lanes)
{
  const Vertex vertex = this->Vertices[v];
  const float shared = SharedPart * fans.GetTolerance();
  while (lanes != 0)
  {
    const float arrival = vertex.Arrivals[LowestBit(lanes)];
    Lanes labels = Lanes::Unreached();
    for (std::uint32_t left = lanes; left != 0; left &= left - 1)
    {
      const int k = LowestBit(left);
      if (std::abs(vertex.Arrivals[k] - arrival) <= shared)
      {
        labels.Values[k] = vertex.Labels.Values[k];
        lanes &= ~(1u << k);
      }
    }
    fans.ForEach(v, arrival, [&](Offset e) { this->Relax(lengths, labels, e); });
  }
}

template <typename Length>
void ManySources::Relax(const Length* lengths, const Lanes& labels, Offset edge)
{
  const Id t = this->Graph.Targets[edge];
  Vertex& vertex = this->Vertices[t];
  if (!labels.Lowers(lengths[edge], vertex.Labels))
  {
    return;
  }
  double smallest = Infinity;
  const std::uint32_t lowered = labels.Lower(lengths[edge], vertex.Labels, smallest);
  vertex.New |= lowered;
  const float arrival = this->Fans ? this->Graph.ArrivalAngles[edge] : -1.0f;
  for (int k = 0; k < Lanes::Size; ++k)
  {
    vertex.Arrivals[k] = (lowered >> k & 1u) != 0 ? arrival : vertex.Arrivals[k];
  }
  const float key = this->Queue.Key(smallest);
  if (smallest <= this->Radius && key < vertex.Key)
  {
    vertex.Key = key;
    this->Queue.Push(smallest, t);
  }
}

template <typename Length>
void ManySources::Certify(const Length* lengths)
{
  this->Queue.Reset(0.0, this->BucketWidth);
  const Offset last = this->Graph.GetNumberOfEdges() - 1;
  for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
  {
    const Lanes labels = this->Vertices[v].Labels;
    for (Offset e = this->Graph.Offsets[v]; e < this->Graph.Offsets[v + 1]; ++e)
    {
      Prefetch(&this->Vertices[this->Graph.Targets[std::min(e + EdgeLookahead, last)]].Labels);
      this->Relax(lengths, labels, e);
    }
  }
}
}
