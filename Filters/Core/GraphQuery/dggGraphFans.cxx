// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphFans.h"

#include <cmath>

namespace dgg
{
namespace
{
/// Half of the width of a fan in units of the angle that one edge of the graph may deviate by. Two
/// edges in a row may differ by 2. Below that the certification finds a few vertices more to mend
/// (one in 300 to 10,000 at 1.6), which is cheaper than longer fans; at 1.2 it no longer is.
constexpr double FanWidth = 1.6;
/// The mean degree of a guaranteed graph is about this over the root of the accuracy.
constexpr double DegreeFactor = 5.3;

}

double LargestDeviation(const GraphView& graph)
{
  double accuracy = graph.Info.Accuracy;
  if (graph.Info.Construction == GraphConstruction::SaddleVertexGraph)
  {
    // That of a guaranteed graph of the same degree.
    const double degree =
      static_cast<double>(graph.GetNumberOfEdges()) / std::max<double>(1.0, graph.NumberOfVertices);
    accuracy = std::pow(DegreeFactor / std::max(degree, DegreeFactor), 2.0);
  }
  return std::acos(1.0 / (1.0 + std::max(0.0, accuracy)));
}

GraphFans::GraphFans(const GraphView& graph, const SurfaceMesh& mesh)
  : Vertices(graph.NumberOfVertices)
  , Angles(graph.Angles)
  , Tolerance(static_cast<float>(FanWidth * LargestDeviation(graph)))
{
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    Vertex& vertex = this->Vertices[v];
    vertex.Begin = graph.Offsets[v];
    vertex.Degree = static_cast<std::uint32_t>(graph.Offsets[v + 1] - graph.Offsets[v]);
    const VertexKind kind = mesh.Kind(v);
    const double total = mesh.TotalAngle(v);
    if (kind == VertexKind::Irregular || kind == VertexKind::Isolated || !(total > 0.0))
    {
      continue;
    }
    const bool isBoundary = kind == VertexKind::Boundary;
    // Straight on is half of the total angle where that is less than pi; where it is more, every
    // departure is straight that leaves pi on both sides. The outside of a boundary is wide.
    const double straight = std::min(Pi, isBoundary ? total : 0.5 * total);
    vertex.Lead = static_cast<float>(straight - this->Tolerance);
    vertex.Turn = static_cast<float>(isBoundary ? 3.0 * total : total);
    vertex.PerAngle = static_cast<float>(vertex.Degree / total);
  }
}
}
