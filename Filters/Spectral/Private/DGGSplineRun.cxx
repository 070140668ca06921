// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGSplineRun.h"

#include "DGGContext.h"
#include "DGGDistribution.h"
#include "DGGSurfaceArrays.h"

#include "dggGeodesicSource.h"
#include "dggStatus.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggSplineSites.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Progress of Prepare() after the computation of cells.
constexpr double CellsDone = 0.6;

/// Returns the values of a piecewise linear function at surface points.
std::vector<double> Interpolate(const dgg::SurfaceMesh& mesh,
  const std::vector<dgg::SurfacePoint>& points, const std::vector<double>& values)
{
  std::vector<double> found(points.size(), 0.0);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    dgg::ForEachCornerAround(
      mesh, points[k], [&](dgg::Id v, double weight, double) { found[k] += weight * values[v]; });
  }
  return found;
}

/// Returns integrated sources per vertex from numbers per point; zero at vertices with prescribed
/// values.
std::vector<double> Integrate(const dgg::PreparedSurface& prepared,
  const dgg::PoissonSolver& solver, const std::vector<double>& numbers, bool isDensity,
  double& imbalance)
{
  const std::size_t n = solver.GetAreas().size();
  std::vector<double> sources(n, 0.0);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const dgg::Id v = prepared.GetVertex(static_cast<vtkIdType>(i));
    const bool isFirst = v == static_cast<dgg::Id>(i);
    if (!solver.IsFixed(v) && (isFirst || !isDensity))
    {
      sources[v] += isDensity ? numbers[i] * solver.GetAreas()[v] : numbers[i];
    }
  }
  dgg::Id count = 0;
  const std::vector<dgg::Id> components = solver.GetMesh().ComputeComponents(count);
  std::vector<double> sums(count, 0.0);
  std::vector<double> sizes(count, 0.0);
  std::vector<char> isGiven(count, 0);
  for (std::size_t v = 0; v < n; ++v)
  {
    const bool hasFace = solver.GetAreas()[v] > 0.0;
    sums[components[v]] += hasFace ? sources[v] : 0.0;
    sizes[components[v]] += std::abs(sources[v]);
    isGiven[components[v]] |= solver.IsFixed(static_cast<dgg::Id>(v)) ? 1 : 0;
  }
  imbalance = 0.0;
  for (dgg::Id c = 0; c < count; ++c)
  {
    const bool counts = !isGiven[c] && sizes[c] > 0.0;
    imbalance = counts ? std::max(imbalance, std::abs(sums[c]) / sizes[c]) : imbalance;
  }
  return sources;
}

/// Appends the values of some points of `data`. `where` is the name of the data in messages.
dgg::Status AppendValues(const std::string& name, vtkPolyData* data, const std::string& where,
  const std::vector<vtkIdType>& ids, std::vector<std::vector<double>>& values)
{
  vtkAbstractArray* found = data->GetPointData()->GetAbstractArray(name.c_str());
  vtkDataArray* array = nullptr;
  if (!found)
  {
    return dgg::InvalidInput("There is no point array '", name, "' on ", where)
      .At("SiteValuesArrayName")
      .Fix("Set {SiteValuesArrayName} to the name of a point array");
  }
  DGG_RETURN_IF_ERROR(DGGCheckPointArray(found, data, where, 0, array));
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  if (!values.empty() && values.size() != components)
  {
    return dgg::InvalidInput("The point array '", name, "' of ", where, " has ", components,
      " components, but that of the surface has ", values.size())
      .At("SiteValuesArrayName")
      .Fix("Use the same number of components");
  }
  values.resize(components);
  for (const vtkIdType id : ids)
  {
    for (std::size_t c = 0; c < components; ++c)
    {
      const double value = array->GetComponent(id, static_cast<int>(c));
      if (!std::isfinite(value))
      {
        return dgg::InvalidInput("The point array '", name, "' of ", where, " has the value ",
          value, " at point ", id, ", which is a site")
          .At("SiteValuesArrayName", id)
          .Fix("Use finite values at sites");
      }
      values[c].push_back(value);
    }
  }
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
dgg::Id DGGFindNearestCorner(const dgg::PoissonSolver& solver, const dgg::SurfacePoint& point)
{
  dgg::Id nearest = dgg::NoId;
  double least = 0.0;
  bool isFree = false;
  dgg::ForEachCornerAround(solver.GetMesh(), point, [&](dgg::Id v, double, double distance) {
    const bool isBetter = !solver.IsFixed(v) && !isFree;
    const bool isWorse = solver.IsFixed(v) && isFree;
    if (nearest == dgg::NoId || isBetter || (!isWorse && distance < least))
    {
      nearest = v;
      least = distance;
      isFree = !solver.IsFixed(v);
    }
  });
  return nearest;
}

//------------------------------------------------------------------------------
dgg::Status DGGReadRightHandSide(
  vtkPolyData* surface, const std::string& name, std::vector<double>& values)
{
  return DGGReadNumbers(surface, name, "the surface", "RightHandSideArrayName", false, values);
}

//------------------------------------------------------------------------------
dgg::Status DGGReadSiteValues(const std::string& name, vtkPolyData* surface,
  const std::vector<vtkIdType>& ids, vtkPolyData* points, std::vector<std::vector<double>>& values)
{
  values.clear();
  const vtkIdType count = points ? points->GetNumberOfPoints() : 0;
  if (!ids.empty() || count == 0)
  {
    DGG_RETURN_IF_ERROR(AppendValues(name, surface, "the surface", ids, values));
  }
  std::vector<vtkIdType> all;
  for (vtkIdType i = 0; i < count; ++i)
  {
    all.push_back(i);
  }
  return count > 0 ? AppendValues(name, points, "input port 1", all, values)
                   : dgg::Status::Success();
}

//------------------------------------------------------------------------------
DGGSplineRun::DGGSplineRun(DGGSpectralTask& task, bool isBiharmonic, bool isSmooth)
  : Task(task)
  , Mesh(task.Solver.GetMesh())
  , IsBiharmonic(isBiharmonic)
  , IsSmooth(isSmooth && !isBiharmonic && !task.Targets.empty())
  , Harmonic(task.Solver)
  , Biharmonic(task.Solver)
{
}

//------------------------------------------------------------------------------
dgg::Status DGGSplineRun::Prepare(bool wantsFunctions, const dgg::ProgressCallback& progress)
{
  const dgg::ParallelFor& parallel = this->Task.Context.Parallel;
  if (this->IsBiharmonic)
  {
    return wantsFunctions ? this->Biharmonic.Prepare(this->Task.Sources, parallel, progress)
                          : dgg::CheckSplinePlaces(this->Task.Solver, this->Task.Sources);
  }
  std::vector<dgg::Id> sites;
  for (const dgg::SurfacePoint& source : this->Task.Sources)
  {
    sites.push_back(source.Vertex);
  }
  const double done = this->IsSmooth ? CellsDone : 1.0;
  DGG_RETURN_IF_ERROR(
    this->Harmonic.Prepare(sites, parallel, dgg::ProgressPart(progress, 0.0, done)));
  return this->IsSmooth
    ? this->Harmonic.Evaluate(this->Task.Targets, dgg::GreensMethod::SingularitySubtraction,
        parallel, dgg::ProgressPart(progress, done, 1.0), this->Evaluated)
    : dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGSplineRun::FindBasis(
  bool isResult, bool isKept, const dgg::ProgressCallback& progress)
{
  const std::vector<dgg::SurfacePoint>& sites = this->Task.Sources;
  const bool isAtSites = isKept && !this->IsBiharmonic;
  this->AtSites.assign(isAtSites ? sites.size() * sites.size() : 0, 0.0);
  const auto consume = [&](dgg::Id site, const std::vector<double>& values) {
    const auto j = static_cast<std::size_t>(site);
    for (std::size_t i = 0; i < sites.size() && isAtSites; ++i)
    {
      this->AtSites[j * sites.size() + i] = values[sites[i].Vertex];
    }
    if (isResult)
    {
      this->Task.Outputs.Set(j, values,
        this->IsSmooth ? this->EvaluatedOf(j)
                       : Interpolate(this->Mesh, this->Task.Targets, values));
    }
  };
  const dgg::ParallelFor& parallel = this->Task.Context.Parallel;
  return this->IsBiharmonic ? this->Biharmonic.FindBasis(parallel, progress, consume)
                            : this->Harmonic.FindBasis(parallel, progress, consume);
}

//------------------------------------------------------------------------------
void DGGSplineRun::AddCells(const std::string& name)
{
  const std::vector<dgg::Id>& cells = this->Harmonic.GetCells();
  std::vector<dgg::Id> targetCells;
  for (const dgg::SurfacePoint& target : this->Task.Targets)
  {
    targetCells.push_back(cells[DGGFindNearestCorner(this->Task.Solver, target)]);
  }
  this->Task.Outputs.Add<vtkIdTypeArray>(name, cells, targetCells);
}

//------------------------------------------------------------------------------
dgg::Status DGGSplineRun::AddInterpolation(const std::vector<std::vector<double>>& siteValues,
  const std::string& name, const dgg::ProgressCallback& progress)
{
  const dgg::ParallelFor& parallel = this->Task.Context.Parallel;
  std::vector<std::vector<double>> functions;
  DGG_RETURN_IF_ERROR(this->IsBiharmonic
      ? this->Biharmonic.Interpolate(siteValues, parallel, progress, functions)
      : this->Harmonic.Interpolate(this->AtSites, siteValues, parallel, progress, functions));
  std::vector<std::vector<double>> atTargets;
  for (const std::vector<double>& function : functions)
  {
    atTargets.push_back(Interpolate(this->Mesh, this->Task.Targets, function));
  }
  this->Task.Outputs.AddColumns(name, functions, atTargets);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGSplineRun::AddSolution(const std::vector<double>& numbers, bool isDensity,
  const std::string& solutionName, double& imbalance)
{
  const std::vector<double> sources =
    Integrate(this->Task.Context.Surface, this->Task.Solver, numbers, isDensity, imbalance);
  std::vector<double> coefficients;
  std::vector<std::vector<double>> solution{ sources };
  if (this->IsBiharmonic)
  {
    DGG_RETURN_IF_ERROR(this->Task.Solver.SolveBiLaplace(solution));
  }
  else
  {
    DGG_RETURN_IF_ERROR(this->Harmonic.Solve(sources, {}, coefficients));
    DGG_RETURN_IF_ERROR(this->Harmonic.Combine(coefficients, {}, solution[0]));
  }
  std::vector<double> atTargets = Interpolate(this->Mesh, this->Task.Targets, solution[0]);
  if (this->IsSmooth)
  {
    std::fill(atTargets.begin(), atTargets.end(), 0.0);
    for (std::size_t site = 0; site < coefficients.size(); ++site)
    {
      const std::vector<double> function = this->EvaluatedOf(site);
      for (std::size_t k = 0; k < function.size(); ++k)
      {
        atTargets[k] += coefficients[site] * function[k];
      }
    }
  }
  this->Task.Outputs.Add<vtkDoubleArray>(solutionName, solution[0], atTargets);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Returns the function of a site at the targets.
std::vector<double> DGGSplineRun::EvaluatedOf(std::size_t site) const
{
  std::vector<double> values;
  for (std::size_t k = site; k < this->Evaluated.size(); k += this->Task.Sources.size())
  {
    values.push_back(this->Evaluated[k]);
  }
  return values;
}
