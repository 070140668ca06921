// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphDijkstra.h"

namespace dgg
{
namespace
{
/// Vertices between two progress reports: some milliseconds.
constexpr std::size_t ProgressInterval = 16384;

template <typename Length>
bool Run(const GraphView& graph, const Length* lengths, const ProgressCallback& progress,
  MinimumHeap& heap, SearchLabels& labels, SearchEffort& effort)
{
  double* const distances = labels.Distances.data();
  while (!heap.IsEmpty())
  {
    const MinimumHeap::Entry top = heap.Pop();
    const Id v = top.Index;
    if (top.Key > distances[v]) // the label has been lowered since
    {
      continue;
    }
    ++effort.Pops;
    if (effort.Pops % ProgressInterval == 0 && progress &&
      !progress(static_cast<double>(effort.Pops) / graph.NumberOfVertices))
    {
      return false;
    }
    const Offset end = graph.Offsets[v + 1];
    effort.Relaxations += static_cast<std::size_t>(end - graph.Offsets[v]);
    for (Offset e = graph.Offsets[v]; e < end; ++e)
    {
      const double distance = top.Key + lengths[e];
      const Id t = graph.Targets[e];
      if (distance < distances[t] && distance < labels.Limit)
      {
        labels.SetDistance(t, distance);
        labels.Origins[t].Edge = e;
        labels.Origins[t].Tail = v;
        heap.Push(distance, t);
      }
    }
  }
  return true;
}
}

bool RunDijkstra(const GraphView& graph, const std::vector<GraphSeed>& seeds,
  const ProgressCallback& progress, MinimumHeap& heap, SearchLabels& labels, SearchEffort& effort)
{
  heap.Clear();
  for (const GraphSeed& seed : seeds)
  {
    if (seed.Distance == labels.Distances[seed.Vertex])
    {
      heap.Push(seed.Distance, seed.Vertex);
    }
  }
  return WithLengths(graph,
    [&](const auto* lengths) { return Run(graph, lengths, progress, heap, labels, effort); });
}
}
