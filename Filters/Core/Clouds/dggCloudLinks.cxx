// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudLinks.h"

#include "dggCloudFrame.h"
#include "dggGraphSeeds.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Placeholder for the direction of a link of a point near a cloud point, which is undefined.
constexpr double NearPoint = 0.0;

Point3 GetPosition(const double* positions, const SurfacePoint& point)
{
  const Point3 p = PointAt(positions, point.Vertex);
  const auto& offset = point.Barycentric;
  return point.On == SurfacePoint::Support::Near ? p + Point3{ offset[0], offset[1], offset[2] }
                                                 : p;
}

/// Returns the ratio of the surface distance to the straight distance on an edge from a vertex.
double GetArcFactor(const GraphView& graph, const double* positions, Id vertex, Offset edge)
{
  const double chord = Norm(PointAt(positions, vertex) - PointAt(positions, graph.Targets[edge]));
  // Edges between coincident points have a positive length.
  return chord > 0.0 ? std::max(1.0, graph.Length(edge) / chord) : 1.0;
}

double MeasureDirectly(
  const GraphView& graph, const double* positions, const SurfacePoint& a, const SurfacePoint& b)
{
  if (IsVertex(a) || IsVertex(b))
  {
    return Infinity; // already connected by the links of the other point
  }
  const double straight = Norm(GetPosition(positions, a) - GetPosition(positions, b));
  if (a.Vertex == b.Vertex)
  {
    return straight;
  }
  // The smaller id comes first, so that both orders give the same bits.
  const Id from = std::min(a.Vertex, b.Vertex);
  const Id to = std::max(a.Vertex, b.Vertex);
  const Id* begin = graph.Targets + graph.Offsets[from];
  const Id* end = graph.Targets + graph.Offsets[from + 1];
  const Id* found = std::lower_bound(begin, end, to); // rows are sorted
  return found == end || *found != to
    ? Infinity
    : straight * GetArcFactor(graph, positions, from, graph.Offsets[from] + (found - begin));
}
}

//------------------------------------------------------------------------------
void LinkToCloud(const GraphView& graph, const double* positions, const SurfacePoint& point,
  const std::vector<SurfacePoint>& aims, std::vector<GraphLink>& links, std::vector<double>& direct)
{
  direct.clear();
  for (const SurfacePoint& aim : aims)
  {
    direct.push_back(MeasureDirectly(graph, positions, point, aim));
  }
  const Id nearest = point.Vertex;
  if (IsVertex(point))
  {
    links = { LinkOfVertex(nearest) };
    return;
  }
  const Point3 p = GetPosition(positions, point);
  links = { { nearest, Norm(p - PointAt(positions, nearest)), NearPoint, 0.0 } };
  for (Offset e = graph.Offsets[nearest]; e < graph.Offsets[nearest + 1]; ++e)
  {
    const Id target = graph.Targets[e];
    const double straight = Norm(p - PointAt(positions, target));
    links.push_back(
      { target, straight * GetArcFactor(graph, positions, nearest, e), NearPoint, 0.0 });
  }
}
}
