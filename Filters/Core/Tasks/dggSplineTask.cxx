// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSplineTask.h"

#include "dggBiharmonicSplines.h"
#include "dggCounted.h"
#include "dggGeodesicSource.h"
#include "dggHarmonicSplines.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggPropertyChecks.h"
#include "dggSplineSites.h"
#include "dggStatus.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dgg
{
namespace
{
/// Progress after the preparation, the basis functions and the solution.
constexpr double PreparationDone = 0.4;
constexpr double BasisDone = 0.8;
constexpr double SolutionDone = 0.85;
/// Progress of the preparation after the computation of cells.
constexpr double CellsDone = 0.6;
/// Largest sum of sources without a warning, relative to the sum of their absolute values. The
/// integral of a density depends on the mesh.
constexpr double DensityTolerance = 1e-2;
constexpr double IntegralTolerance = 1e-6;
/// Bytes per point and thread, without smooth evaluation, and numbers per point that are kept:
/// cells, sources, solutions.
constexpr double SplineBytesPerVertex = 450.0;
constexpr double HeldNumbers = 7.0;
/// Numbers per point and component of an interpolation: functions, and their array.
constexpr double InterpolationNumbers = 2.0;
/// Number of simultaneous matrices of pairs of sites: functions at sites and factors.
constexpr double SiteMatrices = 4.0;

/// Returns the values of a piecewise linear function at surface points.
std::vector<double> Interpolate(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points,
  const std::vector<double>& values)
{
  std::vector<double> found(points.size(), 0.0);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    ForEachCornerAround(
      mesh, points[k], [&](Id v, double weight, double) { found[k] += weight * values[v]; });
  }
  return found;
}

/// Returns the corner closest to a surface point, preferably a corner without a prescribed value.
Id FindNearestCorner(const PoissonSolver& solver, const SurfacePoint& point)
{
  Id nearest = NoId;
  double least = 0.0;
  bool isFree = false;
  ForEachCornerAround(solver.GetMesh(), point, [&](Id v, double, double distance) {
    const bool isBetter = !solver.IsFixed(v) && !isFree;
    const bool isWorse = solver.IsFixed(v) && isFree;
    if (nearest == NoId || isBetter || (!isWorse && distance < least))
    {
      nearest = v;
      least = distance;
      isFree = !solver.IsFixed(v);
    }
  });
  return nearest;
}

/// Returns the largest absolute sum of sources over a component that must be balanced, relative to
/// the sum of absolute values.
double FindImbalance(const PoissonSolver& solver, const std::vector<double>& sources)
{
  Id count = 0;
  const std::vector<Id> components = solver.GetMesh().ComputeComponents(count);
  std::vector<double> sums(count, 0.0);
  std::vector<double> sizes(count, 0.0);
  std::vector<char> isGiven(count, 0);
  for (std::size_t v = 0; v < sources.size(); ++v)
  {
    const bool hasFace = solver.GetAreas()[v] > 0.0;
    sums[components[v]] += hasFace ? sources[v] : 0.0;
    sizes[components[v]] += std::abs(sources[v]);
    isGiven[components[v]] |= solver.IsFixed(static_cast<Id>(v)) ? 1 : 0;
  }
  double imbalance = 0.0;
  for (Id c = 0; c < count; ++c)
  {
    const bool counts = !isGiven[c] && sizes[c] > 0.0;
    imbalance = counts ? std::max(imbalance, std::abs(sums[c]) / sizes[c]) : imbalance;
  }
  return imbalance;
}

/// Computes the results that a task requests.
class SplineRun
{
public:
  SplineRun(const SplineTask& task, const SpectralRun& run)
    : Task(task)
    , Run(run)
    , Mesh(run.Solver.GetMesh())
    , IsSmooth(task.IsSmooth && !task.IsBiharmonic && !run.Targets.empty())
    , Harmonic(run.Solver)
    , Biharmonic(run.Solver)
  {
  }

  /// Checks the sites. If `wantsFunctions`, prepares functions, which solutions of order 1 require.
  Status Prepare(bool wantsFunctions)
  {
    const ParallelFor& parallel = this->Run.Context.Parallel;
    const ProgressCallback progress = this->Part(0.0, PreparationDone);
    if (this->Task.IsBiharmonic)
    {
      return wantsFunctions ? this->Biharmonic.Prepare(this->Run.Sources, parallel, progress)
                            : CheckSplinePlaces(this->Run.Solver, this->Run.Sources);
    }
    std::vector<Id> sites;
    for (const SurfacePoint& source : this->Run.Sources)
    {
      sites.push_back(source.Vertex);
    }
    const double done = this->IsSmooth ? CellsDone : 1.0;
    DGG_RETURN_IF_ERROR(this->Harmonic.Prepare(sites, parallel, ProgressPart(progress, 0.0, done)));
    return this->IsSmooth
      ? this->Harmonic.Evaluate(this->Run.Targets, GreensMethod::SingularitySubtraction, parallel,
          ProgressPart(progress, done, 1.0), this->Evaluated)
      : Status::Success();
  }

  /// Computes all basis functions. With order 1 their values at sites are kept for interpolation.
  Status FindBasis(bool isKept)
  {
    const std::vector<SurfacePoint>& sites = this->Run.Sources;
    const bool isAtSites = isKept && !this->Task.IsBiharmonic;
    this->AtSites.assign(isAtSites ? sites.size() * sites.size() : 0, 0.0);
    const auto consume = [&](Id site, const std::vector<double>& values) {
      const auto j = static_cast<std::size_t>(site);
      for (std::size_t i = 0; i < sites.size() && isAtSites; ++i)
      {
        this->AtSites[j * sites.size() + i] = values[sites[i].Vertex];
      }
      if (this->Task.WantResult)
      {
        this->Run.Outputs.Set(this->Run.Result, j, values,
          this->IsSmooth ? this->GetEvaluated(j)
                         : Interpolate(this->Mesh, this->Run.Targets, values));
      }
    };
    const ParallelFor& parallel = this->Run.Context.Parallel;
    const ProgressCallback progress = this->Part(PreparationDone, BasisDone);
    return this->Task.IsBiharmonic ? this->Biharmonic.FindBasis(parallel, progress, consume)
                                   : this->Harmonic.FindBasis(parallel, progress, consume);
  }

  /// Adds the site of each point (order 1).
  void AddCells()
  {
    const std::vector<Id>& cells = this->Harmonic.GetCells();
    std::vector<Id> targetCells;
    for (const SurfacePoint& target : this->Run.Targets)
    {
      targetCells.push_back(cells[FindNearestCorner(this->Run.Solver, target)]);
    }
    this->Run.Outputs.Set(
      this->Run.Outputs.Add<Offset>(this->Task.CellName), 0, cells, targetCells);
  }

  /// Adds functions with the given values at the sites.
  Status AddInterpolation(const std::vector<std::vector<double>>& siteValues)
  {
    const ParallelFor& parallel = this->Run.Context.Parallel;
    const ProgressCallback progress = this->Part(SolutionDone, 1.0);
    std::vector<std::vector<double>> functions;
    DGG_RETURN_IF_ERROR(this->Task.IsBiharmonic
        ? this->Biharmonic.Interpolate(siteValues, parallel, progress, functions)
        : this->Harmonic.Interpolate(this->AtSites, siteValues, parallel, progress, functions));
    const auto array =
      this->Run.Outputs.Add<double>(this->Task.InterpolationName, functions.size());
    for (std::size_t c = 0; c < functions.size(); ++c)
    {
      this->Run.Outputs.Set(
        array, c, functions[c], Interpolate(this->Mesh, this->Run.Targets, functions[c]));
    }
    return Status::Success();
  }

  /// Adds the solution for integrated sources.
  Status AddSolution(const std::vector<double>& sources)
  {
    std::vector<double> coefficients;
    std::vector<std::vector<double>> solution{ sources };
    if (this->Task.IsBiharmonic)
    {
      DGG_RETURN_IF_ERROR(this->Run.Solver.SolveBiLaplace(solution));
    }
    else
    {
      DGG_RETURN_IF_ERROR(this->Harmonic.Solve(sources, {}, coefficients));
      DGG_RETURN_IF_ERROR(this->Harmonic.Combine(coefficients, {}, solution[0]));
    }
    std::vector<double> atTargets = Interpolate(this->Mesh, this->Run.Targets, solution[0]);
    if (this->IsSmooth)
    {
      std::fill(atTargets.begin(), atTargets.end(), 0.0);
      for (std::size_t site = 0; site < coefficients.size(); ++site)
      {
        const std::vector<double> function = this->GetEvaluated(site);
        for (std::size_t k = 0; k < function.size(); ++k)
        {
          atTargets[k] += coefficients[site] * function[k];
        }
      }
    }
    this->Run.Outputs.Set(
      this->Run.Outputs.Add<double>(this->Task.SolutionName), 0, solution[0], atTargets);
    return Status::Success();
  }

private:
  ProgressCallback Part(double begin, double end) const
  {
    return ProgressPart(this->Run.Progress, begin, end);
  }

  /// Returns the function of a site at the targets.
  std::vector<double> GetEvaluated(std::size_t site) const
  {
    std::vector<double> values;
    for (std::size_t k = site; k < this->Evaluated.size(); k += this->Run.Sources.size())
    {
      values.push_back(this->Evaluated[k]);
    }
    return values;
  }

  const SplineTask& Task;
  const SpectralRun& Run;
  const SurfaceMesh& Mesh;
  bool IsSmooth;
  HarmonicSplines Harmonic;
  BiharmonicSplines Biharmonic;
  std::vector<double> AtSites;   // basis functions of order 1, in succession
  std::vector<double> Evaluated; // per target and site; empty unless smooth
};
}

//------------------------------------------------------------------------------
Status SplineTask::CheckNames(const std::string& result, const std::string& cell,
  const std::string& solution, const std::string& interpolation)
{
  return dgg::CheckNames({ { "ResultArrayName", result }, { "CellArrayName", cell },
    { "SolutionArrayName", solution }, { "InterpolationArrayName", interpolation } });
}

//------------------------------------------------------------------------------
void SplineTask::Forget()
{
  this->UsedSites.clear();
  this->SiteValues = {};
  this->RightHandSide = this->SurfaceValues = this->PointValues = {};
}

//------------------------------------------------------------------------------
Status SplineTask::CheckInput(const TaskContext& context)
{
  if (!this->SurfaceValues.Name.empty())
  {
    // Chosen sites are not known yet; the array is checked nevertheless.
    DGG_RETURN_IF_ERROR(this->ReadSiteValues(context, this->GivenIds, this->NumberOfGivenPoints));
  }
  return this->RightHandSide.Name.empty()
    ? Status::Success()
    : this->RightHandSide.RequireNumbers("the surface", "RightHandSideArrayName",
        context.Surface.GetMeshWithoutAngles().GetNumberOfVertices(), false);
}

//------------------------------------------------------------------------------
/// Reads the values of sites: first of points of the surface, then of other points.
Status SplineTask::ReadSiteValues(
  const TaskContext& context, const std::vector<Offset>& ids, Offset numberOfPoints)
{
  this->SiteValues.clear();
  if (!ids.empty() || numberOfPoints == 0)
  {
    DGG_RETURN_IF_ERROR(this->AppendSiteValues(this->SurfaceValues, "the surface",
      context.Surface.GetMeshWithoutAngles().GetNumberOfVertices(), &ids));
  }
  return numberOfPoints == 0
    ? Status::Success()
    : this->AppendSiteValues(this->PointValues, "{PointValues}", numberOfPoints, nullptr);
}

//------------------------------------------------------------------------------
/// Appends the values of some points, or of all if `ids` is null.
Status SplineTask::AppendSiteValues(const InputArray& array, const std::string& where,
  Offset numberOfPoints, const std::vector<Offset>* ids)
{
  DGG_RETURN_IF_ERROR(array.RequirePoints(where, "SiteValuesArrayName", numberOfPoints, 0));
  const auto components = static_cast<std::size_t>(array.NumberOfComponents);
  if (!this->SiteValues.empty() && this->SiteValues.size() != components)
  {
    return InvalidInput("The point array '", array.Name, "' of ", where, " has ",
      Counted(components, "component"), ", but that of the surface has ", this->SiteValues.size())
      .At("SiteValuesArrayName")
      .Fix("Use the same number of components");
  }
  this->SiteValues.resize(components);
  const Offset count = ids ? static_cast<Offset>(ids->size()) : numberOfPoints;
  for (Offset i = 0; i < count; ++i)
  {
    for (std::size_t c = 0; c < components; ++c)
    {
      const Offset id = ids ? (*ids)[i] : i;
      const double value = array.Get(id, static_cast<int>(c));
      if (!std::isfinite(value))
      {
        return InvalidInput("The point array '", array.Name, "' of ", where, " has the value ",
          value, " at point ", id, ", which is a site")
          .At("SiteValuesArrayName", id)
          .Fix("Use finite values at sites");
      }
      this->SiteValues[c].push_back(value);
    }
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
std::size_t SplineTask::CountSources(const PoissonSolver& solver, std::size_t given) const
{
  const auto wanted = std::max<std::size_t>(this->NumberOfSites, CountSplineComponents(solver));
  return given > 0 ? given : std::min(wanted, solver.GetAreas().size());
}

//------------------------------------------------------------------------------
Status SplineTask::ChooseSources(const PoissonSolver& solver, const ProgressCallback& progress,
  std::vector<SurfacePoint>& sources) const
{
  for (SurfacePoint& source : sources)
  {
    source =
      this->IsBiharmonic ? source : SurfacePoint::AtVertex(FindNearestCorner(solver, source));
  }
  if (!sources.empty())
  {
    return Status::Success();
  }
  std::vector<Id> sites;
  const Status status = ChooseSplineSites(solver, this->NumberOfSites, progress, sites);
  std::transform(sites.begin(), sites.end(), std::back_inserter(sources), &SurfacePoint::AtVertex);
  return status;
}

//------------------------------------------------------------------------------
double SplineTask::EstimateMemory(const TaskContext& context, const PoissonSolver& solver,
  std::size_t numberOfSources, std::size_t numberOfTargets) const
{
  const auto n = static_cast<double>(solver.GetAreas().size());
  const auto sites = static_cast<double>(numberOfSources);
  const auto targets = static_cast<double>(numberOfTargets);
  const bool isSmooth = this->IsSmooth && !this->IsBiharmonic && numberOfTargets > 0;
  const bool hasMatrices = !this->SiteValues.empty() || (this->IsBiharmonic && this->WantResult);
  const double bytes = isSmooth ? GreensFunction::BytesPerVertex : SplineBytesPerVertex;
  const double held =
    HeldNumbers + InterpolationNumbers * static_cast<double>(this->SiteValues.size());
  // Threads; equations of sites, like those of vertices; cells, solutions, interpolations.
  return bytes * n * context.NumberOfThreads +
    (this->IsBiharmonic ? 0.0 : std::min(1.0, sites / n) * solver.GetEstimatedMemory()) +
    (held * (n + targets) + (isSmooth ? sites * targets : 0.0) +
      (hasMatrices ? SiteMatrices * sites * sites : 0.0)) *
    sizeof(double);
}

//------------------------------------------------------------------------------
Status SplineTask::Compute(const SpectralRun& run)
{
  if (run.Sources.empty())
  {
    return InvalidInput("Values are prescribed at all points, so no point can be a site")
      .At("Boundary")
      .Fix("Set {Boundary} to Neumann");
  }
  std::vector<Offset> sites;
  for (const SurfacePoint& source : run.Sources)
  {
    sites.push_back(IsVertex(source) ? source.Vertex : NoId);
  }
  const bool hasValues = !this->SiteValues.empty();
  if (hasValues && this->GivenIds.empty() && this->NumberOfGivenPoints == 0)
  {
    DGG_RETURN_IF_ERROR(this->ReadSiteValues(run.Context, sites, 0));
  }
  SplineRun splines(*this, run);
  DGG_RETURN_IF_ERROR(splines.Prepare(this->WantResult || hasValues));
  if (this->WantResult || (!this->IsBiharmonic && hasValues))
  {
    DGG_RETURN_IF_ERROR(splines.FindBasis(hasValues));
  }
  if (!this->IsBiharmonic)
  {
    splines.AddCells();
  }
  double imbalance = 0.0;
  if (!this->RightHandSide.Name.empty())
  {
    DGG_RETURN_IF_ERROR(ReportTo(run.Progress, BasisDone));
    std::vector<double> sources = this->RightHandSide.Integrate(
      run.Context.Surface, this->IsDensity ? &run.Solver.GetAreas() : nullptr);
    for (std::size_t v = 0; v < sources.size(); ++v)
    {
      sources[v] = run.Solver.IsFixed(static_cast<Id>(v)) ? 0.0 : sources[v];
    }
    imbalance = FindImbalance(run.Solver, sources);
    DGG_RETURN_IF_ERROR(splines.AddSolution(sources));
  }
  if (hasValues)
  {
    DGG_RETURN_IF_ERROR(splines.AddInterpolation(this->SiteValues));
  }
  if (imbalance > (this->IsDensity ? DensityTolerance : IntegralTolerance))
  {
    run.Warnings.push_back(
      JoinText("The sources in a component of the surface sum to a fraction of ", imbalance,
        " of their absolute values, and no boundary absorbs the sum, so they were balanced in "
        "proportion to area. Make their sum 0"));
  }
  const auto components = static_cast<std::size_t>(CountSplineComponents(run.Solver));
  if (components > 1 && sites.size() == components &&
    run.Solver.GetOptions().Boundary == PoissonBoundary::Neumann)
  {
    run.Warnings.push_back(JoinText("The surface has ", components,
      " components, each with a single site, whose function is 1 everywhere. Use more sites, or a "
      "single component"));
  }
  DGG_RETURN_IF_ERROR(ReportTo(run.Progress, 1.0));
  this->Forget();
  this->UsedSites.swap(sites);
  return Status::Success();
}

//------------------------------------------------------------------------------
void SplineTask::AddEmptyArrays(SpectralOutputs& outputs) const
{
  if (!this->IsBiharmonic)
  {
    outputs.Add<Offset>(this->CellName);
  }
  if (!this->SurfaceValues.Name.empty())
  {
    outputs.Add<double>(this->InterpolationName);
  }
  if (!this->RightHandSide.Name.empty())
  {
    outputs.Add<double>(this->SolutionName);
  }
}
}
