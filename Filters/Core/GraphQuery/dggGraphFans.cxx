// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphFans.h"

#include <cmath>

namespace dgg
{
namespace
{
/// Half the width of a fan, in units of the maximum deviation angle of an edge. Consecutive edges
/// may differ by up to 2. With smaller values the certification has to correct a few more vertices
/// (one in 300 to 10,000 at 1.6), which is cheaper than wider fans; at 1.2 it no longer is.
constexpr double FanWidth = 1.6;
/// The mean degree of a guaranteed graph is about this factor divided by the root of the accuracy.
constexpr double DegreeFactor = 5.3;
/// Minimum mean number of edges per vertex for which fans are worthwhile.
constexpr Offset ShortestLongRow = 55;
}

double LargestDeviation(const GraphView& graph)
{
  return LargestDeviation(graph.Info,
    static_cast<double>(graph.GetNumberOfEdges()) / std::max<double>(1.0, graph.NumberOfVertices));
}

double LargestDeviation(const GraphInfo& graph, double meanDegree)
{
  double accuracy = graph.Accuracy;
  if (graph.Construction == GraphConstruction::SaddleVertexGraph)
  {
    // Accuracy of a guaranteed graph with the same degree.
    accuracy = std::pow(DegreeFactor / std::max(meanDegree, DegreeFactor), 2.0);
  }
  return std::acos(1.0 / (1.0 + std::max(0.0, accuracy)));
}

std::vector<VertexAngle> MeasureVertexAngles(const SurfaceMesh& mesh)
{
  std::vector<VertexAngle> angles(static_cast<std::size_t>(mesh.GetNumberOfVertices()));
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const auto total = static_cast<float>(mesh.TotalAngle(v));
    switch (mesh.Kind(v))
    {
      case VertexKind::Isolated:
      case VertexKind::Irregular:
        break;
      case VertexKind::Boundary:
        angles[v].Total = -total;
        break;
      default:
        angles[v] = { total, static_cast<float>(std::abs(2.0 * Pi - mesh.TotalAngle(v))) };
    }
  }
  return angles;
}

bool GraphFans::AreWorthwhile(const GraphView& graph)
{
  return graph.GetNumberOfEdges() > ShortestLongRow * static_cast<Offset>(graph.NumberOfVertices);
}

GraphFans::GraphFans(const GraphView& graph, const SurfaceMesh& mesh)
  : GraphFans(graph, MeasureVertexAngles(mesh), LargestDeviation(graph))
{
}

GraphFans::GraphFans(
  const GraphView& graph, const std::vector<VertexAngle>& angles, double largestDeviation)
  : Vertices(graph.NumberOfVertices)
  , Angles(graph.Angles)
  , Tolerance(static_cast<float>(FanWidth * largestDeviation))
{
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    Vertex& vertex = this->Vertices[v];
    vertex.Begin = graph.Offsets[v];
    vertex.Degree = static_cast<std::uint32_t>(graph.Offsets[v + 1] - graph.Offsets[v]);
    const bool isBoundary = angles[v].Total < 0.0f;
    const double total = std::abs(angles[v].Total);
    if (total == 0.0)
    {
      continue;
    }
    // Straight continuation leaves half of the total angle on both sides if this half is less than
    // pi; otherwise every departure that leaves pi on both sides is straight. The exterior of a
    // boundary counts as wide.
    const double straight = std::min(Pi, isBoundary ? total : 0.5 * total);
    vertex.Lead = static_cast<float>(straight - this->Tolerance);
    vertex.Turn = static_cast<float>(isBoundary ? 3.0 * total : total);
    vertex.PerAngle = static_cast<float>(vertex.Degree / total);
  }
}
}
