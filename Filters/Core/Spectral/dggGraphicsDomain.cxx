// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsDomain.h"

#include "dggGraphicsChecks.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dgg
{
namespace
{
/// Cut along the curves of which `isMeant` holds.
template <typename Predicate>
Status CutAlong(const RefinedSurface& surface, const std::vector<CurveChain>& chains,
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
    const Status own =
      isMeant(curves[k].Type) ? CheckSides(surface, { chains[k].Vertices }) : Status::Success();
    if (!own.IsOk())
    {
      return Status::Invalid(NameOf(curves[k], k) + ": " + own.GetMessage());
    }
  }
  return status;
}

std::size_t SizeOf(const CurveCut& cut)
{
  std::size_t bytes = GetSurfaceMemory(cut.Surface) + cut.Surface.VertexOf.size() * sizeof(Id);
  for (const CurveSides& sides : cut.Sides)
  {
    bytes += (sides.Left.size() + sides.Right.size()) * sizeof(EdgeSide);
  }
  return bytes;
}
}

std::size_t GraphicsDomain::GetMemorySize() const
{
  return SizeOf(this->Solved) + SizeOf(this->Drawn) + this->SolvedMesh.GetMemorySize() +
    this->DrawnMesh.GetMemorySize() + this->SolvedVertexOf.size() * sizeof(Id);
}

Status CutForGraphics(const SurfaceMesh& mesh, const RefinedSurface& surface,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
  GraphicsDomain& domain)
{
  domain = GraphicsDomain();
  bool hasPoisson = false;
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (chains[k].Vertices.size() < 2)
    {
      return Status::Invalid(
        NameOf(curves[k], k) + " has no length: give it two points in different places");
    }
    hasPoisson = hasPoisson || curves[k].Type == GraphicsCurveType::Poisson;
  }
  const auto isDiffusion = [](GraphicsCurveType type) {
    return type == GraphicsCurveType::Diffusion;
  };
  const auto isCut = [](GraphicsCurveType type) {
    return type == GraphicsCurveType::Diffusion || type == GraphicsCurveType::Poisson;
  };
  Status status =
    CutAlong(surface, chains, curves, isDiffusion, domain.Solved, domain.SidesInSolved);
  status = status.IsOk() ? domain.Solved.Surface.Build(mesh, domain.SolvedMesh) : status;
  if (status.IsOk())
  {
    if (hasPoisson)
    {
      status = CutAlong(surface, chains, curves, isCut, domain.Drawn, domain.SidesInDrawn);
    }
    else
    {
      domain.Drawn = domain.Solved;
      domain.SidesInDrawn = domain.SidesInSolved;
    }
  }
  if (status.IsOk() && hasPoisson)
  {
    status = domain.Drawn.Surface.Build(mesh, domain.DrawnMesh);
  }
  if (!status.IsOk())
  {
    return status;
  }
  domain.SolvedVertexOf.assign(domain.Drawn.Surface.Points.size(), NoId);
  for (std::size_t v = 0; v < surface.Points.size(); ++v)
  {
    domain.SolvedVertexOf[v] = static_cast<Id>(v); // also where there is no face
  }
  for (std::size_t h = 0; h < domain.Drawn.Surface.Triangles.size(); ++h)
  {
    domain.SolvedVertexOf[domain.Drawn.Surface.Triangles[h]] = domain.Solved.Surface.Triangles[h];
  }
  return status;
}

std::size_t GetSurfaceMemory(const RefinedSurface& surface)
{
  return surface.Points.size() * sizeof(SurfacePoint) +
    (surface.Triangles.size() + surface.Twins.size() + surface.Faces.size()) * sizeof(Id) +
    surface.Lengths.size() * sizeof(double);
}

double PredictSolverMemory(double faces, double vertices)
{
  constexpr double id = sizeof(Id);
  constexpr double number = sizeof(double);
  // Half-edges with origin, twin, place in a fan, length, apex and angle; vertices with an angle, a
  // fan and a kind.
  const double mesh = faces * (9.0 * id + 12.0 * number + 1.0) + vertices * (2.0 * number + 1.0);
  const double triangulation = faces * (6.0 * id + 3.0 * number + 3.0);
  const double arrays = vertices * (8.0 * id + 6.0 * number);
  // The matrix of seven entries per vertex; while it is put together, what each half-edge adds to
  // it, in triplets and in rows; then, for the order of elimination, its pattern and half of it.
  const double matrix = 7.0 * vertices * (number + id);
  const double added = 12.0 * faces + vertices;
  const double assembly = added * ((number + 2.0 * id) + (number + id)) + 4.0 * vertices * id;
  const double ordering = 1.5 * matrix;
  return mesh + triangulation + arrays + matrix + std::max(assembly, ordering);
}

double PredictGraphicsMemory(double faces, double vertices, bool hasPoisson)
{
  constexpr double id = sizeof(Id);
  constexpr double number = sizeof(double);
  const double cut = faces * (7.0 * id + 3.0 * number) + vertices * (sizeof(SurfacePoint) + id);
  const double mesh = faces * (9.0 * id + 12.0 * number + 1.0) + vertices * (2.0 * number + 1.0);
  return 3.0 * cut + (hasPoisson ? mesh : 0.0) + PredictSolverMemory(faces, vertices);
}

void InterpolateOnCurve(
  const std::vector<double>& values, int channels, bool isClosed, double parameter, double* result)
{
  const std::size_t given = values.size() / static_cast<std::size_t>(channels);
  const auto count = static_cast<double>(given);
  const double first = std::min(std::max(0.0, std::floor(parameter)), count);
  const double part = parameter - first;
  // A closed curve ends with the point that it starts with.
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
}
