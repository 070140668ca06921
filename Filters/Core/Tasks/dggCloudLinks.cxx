// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudLinks.h"

#include "dggCloudFrame.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Directions that are not used: of a point of the cloud, which is its own link, and of others.
constexpr double AtPoint = -1.0;
constexpr double NearPoint = 0.0;

Point3 PlaceAt(const double* positions, const SurfacePoint& place)
{
  const Point3 p = PointAt(positions, place.Vertex);
  const auto& offset = place.Barycentric;
  return place.On == SurfacePoint::Support::Near ? p + Point3{ offset[0], offset[1], offset[2] }
                                                 : p;
}

/// Returns the ratio of length and chord of an edge.
double GetArcFactor(const GraphView& graph, const double* positions, Id vertex, Offset edge)
{
  const double chord = Norm(PointAt(positions, vertex) - PointAt(positions, graph.Targets[edge]));
  // Edges between coincident points have a length, too.
  return chord > 0.0 ? std::max(1.0, graph.Length(edge) / chord) : 1.0;
}
}

std::vector<GraphLink> LinkToCloud(
  const GraphView& graph, const double* positions, const SurfacePoint& place)
{
  const Id nearest = place.Vertex;
  if (IsVertex(place))
  {
    return { { nearest, 0.0, AtPoint, 0.0 } };
  }
  const Point3 p = PlaceAt(positions, place);
  std::vector<GraphLink> links;
  links.push_back({ nearest, Norm(p - PointAt(positions, nearest)), NearPoint, 0.0 });
  for (Offset e = graph.Offsets[nearest]; e < graph.Offsets[nearest + 1]; ++e)
  {
    const Id target = graph.Targets[e];
    const double straight = Norm(p - PointAt(positions, target));
    links.push_back(
      { target, straight * GetArcFactor(graph, positions, nearest, e), NearPoint, 0.0 });
  }
  return links;
}

double MeasureDirectly(
  const GraphView& graph, const double* positions, const SurfacePoint& a, const SurfacePoint& b)
{
  if (IsVertex(a) || IsVertex(b))
  {
    return Infinity; // the links of the other position include this one
  }
  const double straight = Norm(PlaceAt(positions, a) - PlaceAt(positions, b));
  if (a.Vertex == b.Vertex)
  {
    return straight;
  }
  // From the smaller id, so that the result is bitwise symmetric.
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
