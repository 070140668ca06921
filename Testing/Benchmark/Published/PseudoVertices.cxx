// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PseudoVertices.h"

#include "dggStraightWalk.h"
#include "dggSurfaceRefinement.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Returns the gaps between consecutive angles: start and width of each.
std::vector<std::pair<double, double>> GapsOf(
  const dgg::SurfaceMesh& mesh, const dgg::GraphView& graph, dgg::Id v)
{
  std::vector<std::pair<double, double>> gaps;
  const dgg::Offset begin = graph.Offsets[v];
  const dgg::Offset end = graph.Offsets[v + 1];
  for (dgg::Offset e = begin; e + 1 < end; ++e)
  {
    gaps.emplace_back(graph.Angles[e], graph.Angles[e + 1] - graph.Angles[e]);
  }
  if (end > begin && mesh.Kind(v) != dgg::VertexKind::Boundary)
  {
    gaps.emplace_back(
      graph.Angles[end - 1], graph.Angles[begin] + mesh.TotalAngle(v) - graph.Angles[end - 1]);
  }
  return gaps;
}

double MedianLength(const dgg::GraphView& graph, dgg::Id v)
{
  std::vector<double> lengths;
  for (dgg::Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
  {
    lengths.push_back(graph.Length(e));
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}
}

dgg::Status AddPseudoVertices(const dgg::SurfaceMesh& mesh, const dgg::GraphView& graph,
  double accuracy, dgg::SurfaceMesh& refined, dgg::Id& added)
{
  const double largestGap = std::sqrt(accuracy);
  std::vector<dgg::SurfacePath> places;
  for (dgg::Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    const dgg::VertexKind kind = mesh.Kind(v);
    if (kind == dgg::VertexKind::Irregular || graph.Offsets[v] == graph.Offsets[v + 1])
    {
      continue;
    }
    const double length = MedianLength(graph, v);
    for (const auto& gap : GapsOf(mesh, graph, v))
    {
      const double parts = std::ceil(gap.second / largestGap);
      for (double k = 1.0; k < parts; ++k)
      {
        const double angle = std::fmod(gap.first + gap.second * k / parts, mesh.TotalAngle(v));
        dgg::SurfacePath walk;
        DGG_RETURN_IF_ERROR(
          dgg::WalkStraight(mesh, dgg::SurfacePoint::AtVertex(v), angle, length, walk));
        dgg::SurfacePath place;
        place.Points = { walk.Points.back() };
        places.push_back(std::move(place));
      }
    }
  }
  dgg::SubMesh surface;
  DGG_RETURN_IF_ERROR(dgg::RefineAlongPaths(mesh, places, {}, surface));
  added = surface.GetNumberOfVertices() - mesh.GetNumberOfVertices();
  return surface.Build(mesh, refined);
}
