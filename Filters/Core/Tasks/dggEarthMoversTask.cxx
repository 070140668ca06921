// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggEarthMoversTask.h"

#include "dggBarycentric.h"
#include "dggOutput.h"
#include "dggPoissonSession.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggStatus.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dgg
{
namespace
{
using Vector = std::array<double, 3>;

/// Memory of the search for the flow relative to the memory of the system, since the search
/// factorizes a similar matrix.
constexpr double SearchPart = 1.25;

/// Computes masses per vertex. `areas`, per vertex, is null if the numbers are masses.
Status Integrate(const PreparedSurface& surface, const MassDistribution& distribution,
  const std::vector<double>* areas, std::vector<double>& masses)
{
  masses = distribution.Values.Integrate(surface, areas);
  const std::vector<double>& others = distribution.Masses.Values;
  for (std::size_t i = 0; i < distribution.Places.size(); ++i)
  {
    DGG_RETURN_IF_ERROR(AddPointMass(
      surface.GetMesh(), distribution.Places[i], others.empty() ? 1.0 : others[i], masses));
  }
  return Status::Success();
}

void Normalize(Vector& vector)
{
  const double length = std::sqrt(Dot(vector, vector));
  for (double& x : vector)
  {
    x = length != 0.0 ? x / length : x;
  }
}

/// Returns in space a vector that is given in the frame of a face: x along its first side, y toward
/// its apex. The result has no meaning if corners coincide.
Vector InSpace(const PreparedSurface& surface, Id face, const Point2& vector)
{
  const auto at = [&](Id v) {
    const double* p = surface.GetPositions() + 3 * static_cast<std::size_t>(v);
    return Vector{ { p[0], p[1], p[2] } };
  };
  const std::array<Id, 3> corners = surface.GetMesh().GetTriangle(face);
  Vector x = at(corners[1]) - at(corners[0]);
  Vector y = at(corners[2]) - at(corners[0]);
  Normalize(x);
  const double along = Dot(x, y);
  for (int axis = 0; axis < 3; ++axis)
  {
    y[axis] -= along * x[axis];
  }
  Normalize(y);
  return { { vector.X * x[0] + vector.Y * y[0], vector.X * x[1] + vector.Y * y[1],
    vector.X * x[2] + vector.Y * y[2] } };
}

/// Adds the flow per cell: the mean over its triangles.
void AddFlow(const PreparedSurface& surface, Offset numberOfCells, const std::vector<Point2>& flow,
  double total, Output& output)
{
  const auto n = static_cast<std::size_t>(numberOfCells);
  double* const values = output.CellData.Add<double>(EarthMoversFlowName, n, 3);
  std::fill_n(values, 3 * n, 0.0);
  const SurfaceMesh& mesh = surface.GetMesh();
  const auto areaOf = [&](Id f) { return 0.5 * mesh.Length(3 * f) * mesh.ApexY(3 * f); };
  std::vector<double> areas(n, 0.0);
  for (Id k = 0; k < mesh.GetNumberOfFaces(); ++k)
  {
    const Id f = mesh.GetOriginal(k);
    areas[static_cast<std::size_t>(surface.GetCell(k))] += mesh.IsDropped(f) ? 0.0 : areaOf(f);
  }
  for (Id k = 0; k < mesh.GetNumberOfFaces(); ++k)
  {
    const Id f = mesh.GetOriginal(k);
    const auto cell = static_cast<std::size_t>(surface.GetCell(k));
    if (mesh.IsDropped(f) || !(areas[cell] > 0.0))
    {
      continue;
    }
    const Vector vector = InSpace(surface, f, flow[f]);
    const double part = areaOf(f) / areas[cell] * total;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      values[3 * cell + axis] += part * vector[axis];
    }
  }
}
}

//------------------------------------------------------------------------------
Status MassDistribution::Check(const PreparedSurface& surface) const
{
  const std::string points = "{" + this->PointsProperty + "}";
  if (this->Values.Name.empty() && this->NumberOfPlaces == 0)
  {
    return InvalidInput("There is nothing to move ", this->Role)
      .At(this->Property)
      .Fix("Set {", this->Property, "} to the name of a point array, or add points to ", points);
  }
  if (!this->Values.Name.empty())
  {
    DGG_RETURN_IF_ERROR(this->Values.RequireNumbers(
      "the surface", this->Property, surface.GetMeshWithoutAngles().GetNumberOfVertices(), true));
  }
  return this->NumberOfPlaces == 0 || this->Masses.Name.empty()
    ? Status::Success()
    : this->Masses.RequireNumbers(points, "MassArrayName", this->NumberOfPlaces, true);
}

//------------------------------------------------------------------------------
Status FindEarthMoversDistance(const TaskContext& context, PoissonSession& session,
  const MassDistribution* distributions, const std::string& remedy, EarthMoversTask& task,
  Output& output)
{
  const PreparedSurface& surface = context.Surface;
  PoissonOptions poisson;
  poisson.IntrinsicDelaunay = task.IsIntrinsicDelaunay;
  const auto others = [](const PoissonSolver& solver) {
    return SearchPart * solver.GetEstimatedMemory();
  };
  double prepared = 0.0;
  DGG_RETURN_IF_ERROR(session.Prepare(context, poisson, others, remedy, prepared));
  const PoissonSolver& solver = session.GetSolver();
  std::vector<double> masses[2];
  for (int k = 0; k < 2; ++k)
  {
    DGG_RETURN_IF_ERROR(Integrate(
      surface, distributions[k], task.AreDensities ? &solver.GetAreas() : nullptr, masses[k]));
  }
  double total = 1.0;
  DGG_RETURN_IF_ERROR(
    BalanceMasses(surface.GetMesh(), task.Normalizes, masses[0], masses[1], total));
  EarthMoversResult result;
  EarthMoversOptions options = task.Options;
  options.Progress = ProgressPart(context.Progress, prepared, 1.0);
  DGG_RETURN_IF_ERROR(EarthMovers(solver).Run(masses[0], masses[1], options, result));
  DGG_RETURN_IF_ERROR(ReportTo(context.Progress, 1.0));

  task.Distance = total * result.Distance;
  task.LowerBound = total * result.LowerBound;
  task.Gap = result.GetGap();
  task.Iterations = result.Iterations;
  *output.FieldData.Add<double>("EarthMoversDistance", 1) = task.Distance;
  *output.FieldData.Add<double>("EarthMoversLowerBound", 1) = task.LowerBound;
  const std::size_t n = result.Potential.size();
  double* const potential = output.PointData.Add<double>(EarthMoversPotentialName, n);
  for (std::size_t i = 0; i < n; ++i)
  {
    potential[i] = result.Potential[surface.GetVertex(static_cast<Offset>(i))];
  }
  output.PointScalars = EarthMoversPotentialName;
  if (!result.Flow.empty())
  {
    AddFlow(surface, task.NumberOfCells, result.Flow, total, output);
  }
  if (options.MostIterations > 0 && task.Gap > std::max(options.Tolerance, LeastEarthMoversGap))
  {
    output.Warnings.push_back(JoinText("The distance is between ", task.LowerBound, " and ",
      task.Distance, ", a gap of ", 100.0 * task.Gap, " %, after ", task.Iterations,
      " iterations. Raise {MaximumNumberOfIterations} or {Tolerance}, or improve the triangles"));
  }
  return Status::Success();
}
}
