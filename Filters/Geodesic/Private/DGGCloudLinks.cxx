// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGCloudLinks.h"

#include "dggCloudFrame.h"

#include <algorithm>

namespace
{
/// Directions that mean nothing: of a point of the cloud, which is its own link, and of others.
constexpr double AtPoint = -1.0;
constexpr double NearPoint = 0.0;

dgg::Point3 PlaceAt(const double* positions, const dgg::SurfacePoint& place)
{
  const dgg::Point3 p = dgg::PointAt(positions, place.Vertex);
  const auto& offset = place.Barycentric;
  return place.On == dgg::SurfacePoint::Support::Near
    ? p + dgg::Point3{ offset[0], offset[1], offset[2] }
    : p;
}

/// How much longer the surface is than the straight line, on the edge from a vertex.
double GetArcFactor(
  const dgg::GraphView& graph, const double* positions, dgg::Id vertex, dgg::Offset edge)
{
  const double chord =
    dgg::Norm(dgg::PointAt(positions, vertex) - dgg::PointAt(positions, graph.Targets[edge]));
  // Edges between points at the same place have a length all the same.
  return chord > 0.0 ? std::max(1.0, graph.Length(edge) / chord) : 1.0;
}
}

//------------------------------------------------------------------------------
std::vector<dgg::GraphLink> DGGLinkToCloud(
  const dgg::GraphView& graph, const double* positions, const dgg::SurfacePoint& place)
{
  const dgg::Id nearest = place.Vertex;
  if (dgg::IsVertex(place))
  {
    return { { nearest, 0.0, AtPoint, 0.0 } };
  }
  const dgg::Point3 p = PlaceAt(positions, place);
  std::vector<dgg::GraphLink> links;
  links.push_back({ nearest, dgg::Norm(p - dgg::PointAt(positions, nearest)), NearPoint, 0.0 });
  for (dgg::Offset e = graph.Offsets[nearest]; e < graph.Offsets[nearest + 1]; ++e)
  {
    const dgg::Id target = graph.Targets[e];
    const double straight = dgg::Norm(p - dgg::PointAt(positions, target));
    links.push_back(
      { target, straight * GetArcFactor(graph, positions, nearest, e), NearPoint, 0.0 });
  }
  return links;
}

//------------------------------------------------------------------------------
double DGGMeasureDirectly(const dgg::GraphView& graph, const double* positions,
  const dgg::SurfacePoint& a, const dgg::SurfacePoint& b)
{
  if (dgg::IsVertex(a) || dgg::IsVertex(b))
  {
    return dgg::Infinity; // the links of the other one see to that
  }
  const double straight = dgg::Norm(PlaceAt(positions, a) - PlaceAt(positions, b));
  if (a.Vertex == b.Vertex)
  {
    return straight;
  }
  // From the smaller id, so that both ways round give the same bits.
  const dgg::Id from = std::min(a.Vertex, b.Vertex);
  const dgg::Id to = std::max(a.Vertex, b.Vertex);
  const dgg::Id* begin = graph.Targets + graph.Offsets[from];
  const dgg::Id* end = graph.Targets + graph.Offsets[from + 1];
  const dgg::Id* found = std::lower_bound(begin, end, to); // rows are sorted
  return found == end || *found != to
    ? dgg::Infinity
    : straight * GetArcFactor(graph, positions, from, graph.Offsets[from] + (found - begin));
}
