// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLoopCandidates.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Kinks of paths of a graph without a guarantee.
constexpr double WidestKink = 0.3;

/// Whether a way passes through a vertex between two directions.
bool PassesStraight(const SurfaceMesh& mesh, Id v, double in, double out, double kink)
{
  const double total = mesh.TotalAngle(v);
  const double angle = std::abs(out - in);
  switch (mesh.Kind(v))
  {
    case VertexKind::Irregular:
      return true; // every direction may follow every other
    case VertexKind::Boundary:
      return angle >= std::min(Pi, total) - kink;
    default:
      return std::min(angle, total - angle) >= std::min(Pi, 0.5 * total) - kink;
  }
}
}

/// Between two edges of a path, each may be off by as much as the accuracy lets it be.
double WidestKinkOf(const GraphView& graph)
{
  const double accuracy = graph.Info.Accuracy;
  return accuracy > 0.0 ? 2.0 * std::acos(1.0 / (1.0 + accuracy)) : WidestKink;
}

std::vector<LoopCandidate> FindLoopCandidates(const SurfaceMesh& mesh, const GraphView& graph,
  const std::vector<GraphSeed>& seeds, const SearchResult& result, double kink)
{
  // Direction back to the source; negative at the source itself.
  const auto arrival = [&](Id v) {
    const Offset edge = result.Edges[v];
    return edge >= 0 ? static_cast<double>(graph.ArrivalAngles[edge])
                     : seeds[result.Seeds[v]].ArrivalAngle;
  };
  std::vector<LoopCandidate> candidates;
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    if (!(result.Distances[v] < Infinity))
    {
      continue;
    }
    const double inTail = arrival(v);
    for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      const Id w = graph.Targets[e];
      if (w <= v || result.Edges[w] == e || (result.Tails[v] == w && result.Edges[v] >= 0))
      {
        continue; // the other direction, or an edge of the tree
      }
      const double inHead = arrival(w);
      if ((inTail >= 0.0 && !PassesStraight(mesh, v, inTail, graph.Angles[e], kink)) ||
        (inHead >= 0.0 && !PassesStraight(mesh, w, inHead, graph.ArrivalAngles[e], kink)))
      {
        continue;
      }
      candidates.push_back({ result.Distances[v] + graph.Length(e) + result.Distances[w], v, e });
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const LoopCandidate& a, const LoopCandidate& b) { return a.Length < b.Length; });
  return candidates;
}
}
