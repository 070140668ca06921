// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsDomain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace dgg
{
namespace
{
/// Cuts along the curves for which `isMeant` holds.
template <typename Predicate>
Status CutAlong(const SubMesh& surface, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const Predicate& isMeant, CurveCut& cut,
  std::vector<std::size_t>& numbers)
{
  std::vector<std::vector<Id>> paths;
  numbers.assign(curves.size(), 0);
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    numbers[k] = paths.size();
    if (isMeant(curves[k].Type))
    {
      paths.push_back(chains[k].Vertices);
    }
  }
  Status status = CutAlongCurves(surface, paths, cut);
  for (std::size_t k = 0; k < curves.size() && !status.IsOk(); ++k)
  {
    DGG_RETURN_IF_ERROR(isMeant(curves[k].Type)
        ? CheckSides(surface, { chains[k].Vertices }).Of(NameOf(curves[k], k))
        : Status::Success());
  }
  return status;
}

/// Calls `visit(vertex, curve, isLeft, parameter)` for every end of an edge of a diffusion curve,
/// on both sides.
template <typename Visitor>
void ForEachGiven(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, Visitor&& visit)
{
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type == GraphicsCurveType::Diffusion)
    {
      ForEachEnd(domain.Solved.Sides[domain.SidesInSolved[k]], chains[k],
        [&](Id v, bool isLeft, double parameter) { visit(v, curves[k], isLeft, parameter); });
    }
  }
}
}

std::string NameOf(const GraphicsCurve& curve, std::size_t number)
{
  return curve.Name.empty() ? "Curve " + std::to_string(number) : curve.Name;
}

Status CutForGraphics(const SurfaceMesh& mesh, const SubMesh& surface,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
  GraphicsDomain& domain)
{
  domain = GraphicsDomain();
  bool hasPoisson = false;
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (chains[k].Vertices.size() < 2)
    {
      return InvalidInput(NameOf(curves[k], k), " has no length")
        .Fix("Give it two points at different positions");
    }
    hasPoisson = hasPoisson || curves[k].Type == GraphicsCurveType::Poisson;
  }
  const auto isDiffusion = [](GraphicsCurveType type) {
    return type == GraphicsCurveType::Diffusion;
  };
  const auto isCut = [](GraphicsCurveType type) {
    return type == GraphicsCurveType::Diffusion || type == GraphicsCurveType::Poisson;
  };
  DGG_RETURN_IF_ERROR(
    CutAlong(surface, chains, curves, isDiffusion, domain.Solved, domain.SidesInSolved));
  DGG_RETURN_IF_ERROR(domain.Solved.Surface.Build(mesh, domain.SolvedMesh));
  if (hasPoisson)
  {
    DGG_RETURN_IF_ERROR(
      CutAlong(surface, chains, curves, isCut, domain.Drawn, domain.SidesInDrawn));
    DGG_RETURN_IF_ERROR(domain.Drawn.Surface.Build(mesh, domain.DrawnMesh));
  }
  else
  {
    domain.Drawn = domain.Solved;
    domain.SidesInDrawn = domain.SidesInSolved;
  }
  domain.SolvedVertexOf.assign(domain.Drawn.Surface.Points.size(), NoId);
  for (std::size_t v = 0; v < surface.Points.size(); ++v)
  {
    domain.SolvedVertexOf[v] = static_cast<Id>(v); // also for vertices without a face
  }
  for (std::size_t h = 0; h < domain.Drawn.Surface.Triangles.size(); ++h)
  {
    domain.SolvedVertexOf[domain.Drawn.Surface.Triangles[h]] = domain.Solved.Surface.Triangles[h];
  }
  return Status::Success();
}

void InterpolateOnCurve(
  const std::vector<double>& values, int channels, bool isClosed, double parameter, double* result)
{
  const std::size_t given = values.size() / static_cast<std::size_t>(channels);
  const auto count = static_cast<double>(given);
  const double first = std::min(std::max(0.0, std::floor(parameter)), count);
  const double part = parameter - first;
  // A closed curve repeats its first point at the end.
  const auto indexOf = [&](double i) {
    return static_cast<std::size_t>(i < count ? i : isClosed ? i - count : count - 1.0);
  };
  const std::size_t a = indexOf(first) * static_cast<std::size_t>(channels);
  const std::size_t b = indexOf(first + 1.0) * static_cast<std::size_t>(channels);
  for (int k = 0; k < channels; ++k)
  {
    result[k] = (1.0 - part) * values[a + k] + part * values[b + k];
  }
}

std::vector<Id> FindDirichletVertices(const GraphicsDomain& domain,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves)
{
  std::vector<Id> vertices;
  ForEachGiven(domain, chains, curves,
    [&](Id v, const GraphicsCurve&, bool, double) { vertices.push_back(v); });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void SetDirichletValues(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const std::vector<double>& bands,
  std::vector<std::vector<double>>& columns)
{
  const std::size_t channels = columns.size();
  const std::size_t n = domain.Solved.Surface.Points.size();
  std::vector<double> counts(n, 0.0);
  std::vector<double> color(channels);
  ForEachGiven(
    domain, chains, curves, [&](Id v, const GraphicsCurve& curve, bool isLeft, double parameter) {
      InterpolateOnCurve(isLeft ? curve.Left : curve.Right, static_cast<int>(channels),
        curve.IsClosed, parameter, color.data());
      for (std::size_t c = 0; c < channels; ++c)
      {
        columns[c][v] = (counts[v] == 0.0 ? 0.0 : columns[c][v]) + color[c];
      }
      counts[v] += 1.0;
    });
  std::vector<double> copies(n, 0.0);
  for (const Id v : domain.SolvedVertexOf)
  {
    copies[v] += 1.0;
  }
  for (std::size_t c = 0; c < channels; ++c)
  {
    for (std::size_t v = 0; v < n; ++v)
    {
      columns[c][v] /= std::max(1.0, counts[v]);
    }
    for (std::size_t d = 0; d < domain.SolvedVertexOf.size(); ++d)
    {
      const Id v = domain.SolvedVertexOf[d];
      columns[c][v] -= counts[v] > 0.0 ? bands[channels * d + c] / copies[v] : 0.0;
    }
  }
}
}
