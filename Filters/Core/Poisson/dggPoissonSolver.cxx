// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPoissonSolver.h"

#include "dggPoissonSystem.h"
#include "dggProgressPart.h"
#include "dggThinTriangles.h"

#include <cmath>
#include <string>

namespace dgg
{
namespace
{
/// Progress of Prepare() after the analysis.
constexpr double AnalysisDone = 0.4;
}

std::string NameOf(const SurfacePoint& point)
{
  return IsVertex(point) ? "vertex " + std::to_string(point.Vertex)
                         : "a point of face " + std::to_string(point.Face);
}

PoissonSolver::PoissonSolver(const SurfaceMesh& mesh)
  : System(std::make_unique<PoissonSystem>(mesh))
{
}

PoissonSolver::~PoissonSolver() = default;

Status PoissonSolver::Prepare(
  const PoissonOptions& options, const ProgressCallback& progress, const MemoryCheck& checkMemory)
{
  PoissonSystem& system = *this->System;
  DGG_RETURN_IF_ERROR(system.Analyze(options, ProgressPart(progress, 0.0, AnalysisDone)));
  if (checkMemory)
  {
    const double bytes = system.GetEstimatedMemory();
    DGG_RETURN_IF_ERROR(checkMemory(bytes, system.IsReady() ? 0.0 : bytes));
  }
  DGG_RETURN_IF_ERROR(ReportTo(progress, AnalysisDone));
  DGG_RETURN_IF_ERROR(system.Factorize(ProgressPart(progress, AnalysisDone, 1.0)));
  return ReportTo(progress, 1.0);
}

double PoissonSolver::GetEstimatedMemory() const
{
  return this->System->GetEstimatedMemory();
}

bool PoissonSolver::IsReady() const
{
  return this->System->IsReady();
}

Status PoissonSolver::CheckNumbers(const std::vector<double>& values) const
{
  const PoissonSystem& system = *this->System;
  if (!system.IsReady())
  {
    return InvalidInput("The system has not been factorized").Fix("Call Prepare() first");
  }
  if (values.size() != static_cast<std::size_t>(system.GetNumberOfVertices()))
  {
    return InvalidInput(
      "There are ", values.size(), " values for ", system.GetNumberOfVertices(), " vertices")
      .Fix("Give one value per vertex");
  }
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    if (!std::isfinite(values[v]))
    {
      return InvalidInput("The value of vertex ", v, " is ", values[v]).Fix("Use finite values");
    }
  }
  return Status::Success();
}

Status PoissonSolver::CheckValues(const std::vector<double>& values) const
{
  DGG_RETURN_IF_ERROR(this->CheckNumbers(values));
  return CheckThinSources(*this->System, values, "source");
}

Status PoissonSolver::Solve(std::vector<double>& values) const
{
  DGG_RETURN_IF_ERROR(this->CheckValues(values));
  this->System->Solve(values);
  return Status::Success();
}

Status PoissonSolver::Solve(std::vector<std::vector<double>>& columns) const
{
  for (const std::vector<double>& column : columns)
  {
    DGG_RETURN_IF_ERROR(this->CheckValues(column));
  }
  this->System->Solve(columns);
  return Status::Success();
}

Status PoissonSolver::SolveBiLaplace(std::vector<std::vector<double>>& columns) const
{
  for (const std::vector<double>& column : columns)
  {
    DGG_RETURN_IF_ERROR(this->CheckValues(column));
  }
  this->System->SolveBiLaplace(columns);
  return Status::Success();
}

const SurfaceMesh& PoissonSolver::GetMesh() const
{
  return this->System->GetMesh();
}

const PoissonOptions& PoissonSolver::GetOptions() const
{
  return this->System->GetOptions();
}

const std::vector<double>& PoissonSolver::GetAreas() const
{
  return this->System->GetAreas();
}

double PoissonSolver::GetWeight(Id v) const
{
  return this->System->GetWeight(v);
}

bool PoissonSolver::IsFixed(Id v) const
{
  return this->System->IsFixed(v);
}

Status PoissonSolver::CheckPlace(const SurfacePoint& point) const
{
  const SurfaceMesh& mesh = this->GetMesh();
  DGG_RETURN_IF_ERROR(point.Check(mesh));
  return IsVertex(point) && mesh.FanBegin(point.Vertex) == mesh.FanEnd(point.Vertex)
    ? InvalidInput("Nothing is defined at ", NameOf(point), ", which has no face")
        .Fix("Use a point of the surface")
    : Status::Success();
}

Status PoissonSolver::CheckPole(const SurfacePoint& point) const
{
  DGG_RETURN_IF_ERROR(this->CheckPlace(point));
  const SurfaceMesh& mesh = this->GetMesh();
  const bool isVertex = IsVertex(point);
  const Id v = isVertex ? point.Vertex : mesh.Origin(3 * point.Face);
  const std::string where = "The pole (" + NameOf(point) + ")";
  DGG_RETURN_IF_ERROR(CheckThinPlace(*this->System, this->System->GetComponent(v), where));
  if (isVertex && this->GetOptions().Boundary == PoissonBoundary::Neumann &&
    this->System->IsFixed(v))
  {
    return InvalidInput(where, " has a given value").Fix("Move the pole");
  }
  if (this->GetOptions().Boundary != PoissonBoundary::Dirichlet)
  {
    return Status::Success();
  }
  if (!this->System->HasBoundary(this->System->GetComponent(v)))
  {
    return InvalidInput(where, " lies in a component without a boundary")
      .At("Boundary", v)
      .Fix("Set {Boundary} to Neumann");
  }
  const bool isOnRim = point.On == SurfacePoint::Support::Edge && mesh.Twin(point.HalfEdge) == NoId;
  if ((isVertex && this->System->IsFixed(v)) || isOnRim)
  {
    return InvalidInput(where, " lies on the boundary, where values are given")
      .At("Boundary", v)
      .Fix("Move the point inside, or set {Boundary} to Neumann");
  }
  return Status::Success();
}

int PoissonSolver::GetNumberOfFactorizations() const
{
  return this->System->GetNumberOfFactorizations();
}

Offset PoissonSolver::GetNumberOfFactorEntries() const
{
  return this->System->GetNumberOfFactorEntries();
}
}
