// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLoopCandidates.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Maximum kink of paths of a graph without a guarantee, radians.
constexpr double WidestKink = 0.3;

/// Maximum kink of candidates that are tried first, radians.
constexpr double NarrowKink = 0.3;

/// Returns the kink of a path at a vertex, from `in` to `out`: the excess of its turning angle over
/// that of a straight path, radians.
double KinkAt(const SurfaceMesh& mesh, Id v, double in, double out)
{
  const double total = mesh.TotalAngle(v);
  const double angle = std::abs(out - in);
  switch (mesh.Kind(v))
  {
    case VertexKind::Irregular:
      return 0.0; // a path may continue in any direction
    case VertexKind::Boundary:
      return std::min(Pi, total) - angle;
    default:
      return std::min(Pi, 0.5 * total) - std::min(angle, total - angle);
  }
}

/// Returns the maximum kink between two edges, each of which may deviate by the angle that the
/// accuracy permits, radians.
double WidestKinkOf(const GraphView& graph)
{
  const double accuracy = graph.Info.Accuracy;
  return accuracy > 0.0 ? 2.0 * std::acos(1.0 / (1.0 + accuracy)) : WidestKink;
}

/// Returns, per vertex, the angle as seen from the source within which a loop passes beside the
/// vertex, at most at the distance of the longest edge of the vertex.
std::vector<double> AnglesBeside(const SurfaceMesh& mesh, const SearchResult& result)
{
  std::vector<double> lengths(result.Distances.size(), 0.0);
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    for (const Id v : { mesh.Origin(h), mesh.Destination(h) })
    {
      lengths[v] = std::max(lengths[v], mesh.Length(h));
    }
  }
  for (std::size_t v = 0; v < lengths.size(); ++v)
  {
    lengths[v] = std::atan2(lengths[v], result.Distances[v]);
  }
  return lengths;
}
}

LoopCandidates FindLoopCandidates(const SurfaceMesh& mesh, const GraphView& graph,
  const std::vector<GraphSeed>& seeds, const SearchResult& result)
{
  const double widest = WidestKinkOf(graph);
  const double narrow = std::min(widest, NarrowKink);
  const std::vector<double> beside = AnglesBeside(mesh, result);
  // Returns the direction back to the source; negative at the source itself.
  const auto arrival = [&](Id v) {
    const Offset edge = result.Edges[v];
    return edge >= 0 ? static_cast<double>(graph.ArrivalAngles[edge])
                     : seeds[result.Seeds[v]].ArrivalAngle;
  };
  const auto kinkAt = [&](Id v, double in, double out) {
    return in >= 0.0 ? KinkAt(mesh, v, in, out) : -Infinity;
  };
  LoopCandidates candidates;
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
      const double atTail = kinkAt(v, inTail, graph.Angles[e]);
      if (atTail > widest + beside[v])
      {
        continue;
      }
      const double atHead = kinkAt(w, arrival(w), graph.ArrivalAngles[e]);
      if (atHead > widest + beside[w])
      {
        continue;
      }
      const double length = result.Distances[v] + graph.Length(e) + result.Distances[w];
      (std::max(atTail, atHead) <= narrow ? candidates.Narrow : candidates.Wide)
        .push_back({ length, v, e });
    }
  }
  return candidates;
}
}
