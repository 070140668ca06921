// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggTurnLimits.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Margin added to the accuracy, since lengths and angles are rounded to float.
constexpr double AccuracyMargin = 1e-5;
/// Margin subtracted from the angle, radians.
constexpr float AngleMargin = 1e-4f;

/// Returns the radius around a vertex within which the surface is a cone.
double ConeRadius(const SurfaceMesh& mesh, Id v)
{
  double radius = Infinity;
  for (const Id* h = mesh.FanBegin(v); h != mesh.FanEnd(v); ++h)
  {
    radius = std::min(radius, mesh.ApexY(SurfaceMesh::Next(*h)));
  }
  return radius;
}
}

bool TurnLimits::AreKnown(const GraphView& graph)
{
  return graph.Info.IsGuaranteed() && graph.Info.Accuracy > 0.0 && graph.Angles &&
    graph.ArrivalAngles;
}

TurnLimits::TurnLimits(const GraphView& graph, const SurfaceMesh& mesh)
  : Vertices(graph.NumberOfVertices)
{
  const double excess = graph.Info.Accuracy + AccuracyMargin;
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    const VertexKind kind = mesh.Kind(v);
    if (kind == VertexKind::Irregular || kind == VertexKind::Isolated)
    {
      continue;
    }
    // No edge is shorter than the radius, since there is no vertex inside the cone.
    const double radius = ConeRadius(mesh, v);
    double longest = 0.0;
    for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      longest = std::max(longest, graph.Length(e));
    }
    const double perLength = 0.5 * excess / radius;
    if (perLength * longest < 1.0) // otherwise every turn is allowed
    {
      this->Vertices[v] = { static_cast<float>(perLength), static_cast<float>(longest) };
    }
  }
}

float TurnLimits::SmallestAngle(Id v, float arrivalLength) const
{
  const Vertex& vertex = this->Vertices[v];
  const float sine = 1.0f - (arrivalLength + vertex.LongestEdge) * vertex.PerLength;
  if (vertex.PerLength == 0.0f || !(sine > 0.0f))
  {
    return 0.0f;
  }
  return std::max(0.0f, 2.0f * std::asin(sine) - AngleMargin);
}
}
