// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHarmonicSplines.h"

#include "dggBlockLoop.h"
#include "dggGeodesicSource.h"
#include "dggPoissonSystem.h"
#include "dggSiteEquations.h"
#include "dggSplineCells.h"
#include "dggSplineSites.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>

namespace dgg
{
namespace
{
/// Number of functions solved together.
constexpr Offset BlockSize = GreensFunction::PolesInBlock;
/// Progress of a few functions after they have been solved.
constexpr double SolvedAt = 0.8;
/// Larger sources may overflow when they are summed and multiplied by conductances.
constexpr double LargestSource = 1e290;
using Entries = Eigen::SparseMatrix<double>::InnerIterator;

/// Receives, for a point, its Green's function g(x, y) at all vertices y, as the mean over their
/// cells: 0 at given values and at vertices without a face. Called in any order, by several threads
/// simultaneously.
using PointVisitor = std::function<void(std::size_t point, const std::vector<double>& greens)>;

/// Returns true if a point lies in a component that is too thin and has no given values.
bool IsInThinPart(const PoissonSystem& system, const SurfacePoint& point)
{
  const Id c = system.GetComponent(point);
  return system.IsThin(c) && system.IsFree(c);
}

/// Computes the Green's functions of points. Points with given values, where the functions are 0,
/// and points in thin components are skipped.
Status FindGreensFunctions(const PoissonSolver& solver, const GreensFunction& function,
  const std::vector<SurfacePoint>& points, GreensMethod method, const ParallelFor& parallel,
  const ProgressCallback& progress, const PointVisitor& visit)
{
  const PoissonSystem& system = solver.GetSystem();
  std::vector<std::size_t> free; // points that have a Green's function
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const std::string name = JoinText("Point ", k);
    DGG_RETURN_IF_ERROR(points[k].Check(system.GetMesh()).Of(name));
    if (system.IsFixed(points[k]) || IsInThinPart(system, points[k]))
    {
      continue;
    }
    DGG_RETURN_IF_ERROR(solver.CheckPole(points[k]).Of(name));
    free.push_back(k);
  }
  const auto runBlock = [&](Offset, Offset begin, Offset end, const ProgressCallback& within) {
    std::vector<SurfacePoint> poles;
    for (Offset k = begin; k < end; ++k)
    {
      poles.push_back(points[free[k]]);
    }
    GreensQuery query;
    query.Method = method;
    query.WantIntegrals = true;
    query.Progress = within;
    std::vector<GreensResult> results;
    Status status = function.Run(poles, query, results);
    for (std::size_t k = 0; k < results.size() && status.IsOk(); ++k)
    {
      std::vector<double>& greens = results[k].Integrals;
      for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
      {
        const double area = system.GetArea(v);
        greens[v] = area > 0.0 && !system.IsFixed(v) ? greens[v] / area : 0.0;
      }
      visit(free[begin + static_cast<Offset>(k)], greens);
    }
    return status;
  };
  return ForBlocks(static_cast<Offset>(free.size()), BlockSize, parallel, progress, runBlock);
}
}

class HarmonicSplines::Implementation
{
public:
  explicit Implementation(const PoissonSolver& solver)
    : Solver(solver)
    , System(solver.GetSystem())
    , Function(solver)
  {
  }

  Id GetNumberOfSites() const { return static_cast<Id>(this->Sites.size()); }

  Status Check() const
  {
    return CheckPreparedSites(this->System, this->Sites.size(), this->Revision);
  }

  /// Returns the share of a vertex in the source of its cell.
  double ShareOf(Id v) const
  {
    return this->System.GetWeight(v) / this->Cells.Weights[this->Cells.Cells[v]];
  }

  /// Returns the mean of a basis function; 0 where values are given.
  double MeanOf(Id site) const
  {
    return this->System.IsFree(this->Cells.Components[site]) ? this->Cells.Weights[site] : 0.0;
  }

  /// Distributes the sources of cells over their vertices. Given values are unchanged.
  void Spread(const std::vector<double>& charges, std::vector<double>& values) const
  {
    for (Id v = 0; v < this->System.GetNumberOfVertices(); ++v)
    {
      if (this->Cells.Cells[v] != NoId)
      {
        values[v] = charges[this->Cells.Cells[v]] * this->ShareOf(v);
      }
      else if (!this->System.IsFixed(v))
      {
        values[v] = 0.0;
      }
    }
  }

  const PoissonSolver& Solver;
  const PoissonSystem& System;
  GreensFunction Function;
  std::vector<Id> Sites;
  SplineCells Cells;
  std::uint64_t Revision = 0; // revision of the system of the cells
};

HarmonicSplines::HarmonicSplines(const PoissonSolver& solver)
  : Internals(std::make_unique<Implementation>(solver))
{
}

HarmonicSplines::~HarmonicSplines() = default;

Status HarmonicSplines::Prepare(
  const std::vector<Id>& sites, const ParallelFor& parallel, const ProgressCallback& progress)
{
  Implementation& internals = *this->Internals;
  internals.Sites.clear();
  internals.Cells = SplineCells();
  DGG_RETURN_IF_ERROR(CheckSplineSites(internals.Solver, sites));
  DGG_RETURN_IF_ERROR(
    FindSplineCells(internals.System, sites, parallel, progress, internals.Cells));
  internals.Sites = sites;
  internals.Revision = internals.System.GetRevision();
  return Status::Success();
}

const std::vector<Id>& HarmonicSplines::GetCells() const
{
  return this->Internals->Cells.Cells;
}

Status HarmonicSplines::FindBasis(
  const ParallelFor& parallel, const ProgressCallback& progress, const Consumer& consume) const
{
  const Implementation& internals = *this->Internals;
  DGG_RETURN_IF_ERROR(internals.Check());
  const PoissonSystem& system = internals.System;
  const auto n = static_cast<std::size_t>(system.GetNumberOfVertices());
  const auto runBlock = [&](Offset, Offset begin, Offset end, const ProgressCallback& within) {
    std::vector<std::vector<double>> columns(
      static_cast<std::size_t>(end - begin), std::vector<double>(n, 0.0));
    for (Offset site = begin; site < end; ++site)
    {
      std::vector<double> charges(internals.Sites.size(), 0.0);
      for (Entries entry(internals.Cells.Stiffness, site); entry; ++entry)
      {
        charges[entry.row()] = entry.value();
      }
      internals.Spread(charges, columns[site - begin]);
    }
    system.Solve(columns);
    if (!within(SolvedAt))
    {
      return Status::Abort();
    }
    for (Offset site = begin; site < end; ++site)
    {
      std::vector<double>& values = columns[site - begin];
      const double mean = internals.MeanOf(static_cast<Id>(site));
      for (std::size_t v = 0; v < n; ++v)
      {
        const Id component = system.GetComponent(static_cast<Id>(v));
        values[v] = component == internals.Cells.Components[site] ? mean + values[v] : 0.0;
      }
      consume(static_cast<Id>(site), values);
    }
    return Status::Success();
  };
  return ForBlocks(
    static_cast<Offset>(internals.Sites.size()), BlockSize, parallel, progress, runBlock);
}

Status HarmonicSplines::Evaluate(const std::vector<SurfacePoint>& points, GreensMethod method,
  const ParallelFor& parallel, const ProgressCallback& progress, std::vector<double>& values) const
{
  values.clear();
  const Implementation& internals = *this->Internals;
  DGG_RETURN_IF_ERROR(internals.Check());
  const std::size_t count = internals.Sites.size();
  const PoissonSystem& system = internals.System;
  std::vector<double> found(points.size() * count, 0.0);
  DGG_RETURN_IF_ERROR(FindGreensFunctions(internals.Solver, internals.Function, points, method,
    parallel, progress, [&](std::size_t k, const std::vector<double>& greens) {
      const Id component = system.GetComponent(points[k]);
      std::vector<double> means(count, 0.0); // means of the Green's function over the cells
      for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
      {
        if (internals.Cells.Cells[v] != NoId)
        {
          means[internals.Cells.Cells[v]] += internals.ShareOf(v) * greens[v];
        }
      }
      for (Id j = 0; j < static_cast<Id>(count); ++j)
      {
        double sum = 0.0;
        for (Entries entry(internals.Cells.Stiffness, j); entry; ++entry)
        {
          sum += entry.value() * means[entry.row()];
        }
        const bool isHere = internals.Cells.Components[j] == component;
        found[k * count + j] = isHere ? internals.MeanOf(j) + sum : 0.0;
      }
    }));
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const Id component = system.GetComponent(points[k]);
    for (std::size_t j = 0; j < count && IsInThinPart(system, points[k]); ++j)
    {
      // There is a single site, see CheckSplineSites(), whose function is 1.
      found[k * count + j] = internals.Cells.Components[j] == component ? 1.0 : 0.0;
    }
  }
  values.swap(found);
  return Status::Success();
}

Status HarmonicSplines::Solve(const std::vector<double>& rightHandSide,
  const std::vector<Id>& given, std::vector<double>& coefficients) const
{
  const Implementation& internals = *this->Internals;
  DGG_RETURN_IF_ERROR(internals.Check());
  DGG_RETURN_IF_ERROR(internals.Solver.CheckValues(rightHandSide));
  const Id count = internals.GetNumberOfSites();
  for (const Id site : given)
  {
    if (site < 0 || site >= count || coefficients.size() != static_cast<std::size_t>(count) ||
      !std::isfinite(coefficients[site]))
    {
      return InvalidInput("The given site ", site, " of ", count, " has no finite value")
        .Fix("Give a finite value");
    }
  }
  std::vector<double> solution = coefficients;
  if (!SolveSiteEquations(internals.System, internals.Cells, rightHandSide, given, solution))
  {
    const bool isHuge = std::any_of(rightHandSide.begin(), rightHandSide.end(),
      [](double f) { return std::abs(f) > LargestSource; });
    return InvalidInput("The equations of the sites could not be solved")
      .Fix(isHuge
          ? "Divide the values of the right-hand side, some of which exceed 1e290, by a number"
          : "Choose other sites or turn on {IntrinsicDelaunay}: some cells do not conduct");
  }
  coefficients.swap(solution);
  return Status::Success();
}

Status HarmonicSplines::Combine(const std::vector<double>& coefficients,
  const std::vector<double>& givenValues, std::vector<double>& values) const
{
  values.clear();
  const Implementation& internals = *this->Internals;
  const PoissonSystem& system = internals.System;
  const SplineCells& cells = internals.Cells;
  DGG_RETURN_IF_ERROR(internals.Check());
  DGG_RETURN_IF_ERROR(
    givenValues.empty() ? Status::Success() : internals.Solver.CheckNumbers(givenValues));
  if (coefficients.size() != internals.Sites.size())
  {
    return InvalidInput(
      "There are ", coefficients.size(), " coefficients for ", internals.Sites.size(), " sites")
      .Fix("Give one coefficient per site");
  }
  std::vector<double> means(system.GetNumberOfComponents(), 0.0);
  std::vector<double> charges(coefficients.size(), 0.0);
  for (Id j = 0; j < internals.GetNumberOfSites(); ++j)
  {
    means[cells.Components[j]] += internals.MeanOf(j) * coefficients[j];
    // Differences, so that constants give exactly 0.
    for (Entries entry(cells.Stiffness, j); entry; ++entry)
    {
      charges[j] += entry.value() * (coefficients[entry.row()] - coefficients[j]);
    }
  }
  for (const SplineCells::Rim& rim : cells.Rims)
  {
    const double value = givenValues.empty() ? 0.0 : givenValues[rim.Vertex];
    charges[rim.Site] += rim.Coefficient * (coefficients[rim.Site] - value);
  }
  values.assign(system.GetNumberOfVertices(), 0.0);
  for (Id v = 0; v < system.GetNumberOfVertices() && !givenValues.empty(); ++v)
  {
    values[v] = system.IsFixed(v) ? givenValues[v] : 0.0;
  }
  internals.Spread(charges, values);
  system.Solve(values);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    values[v] += cells.Cells[v] == NoId ? 0.0 : means[system.GetComponent(v)];
  }
  return Status::Success();
}

Status HarmonicSplines::Interpolate(const std::vector<double>& atSites,
  const std::vector<std::vector<double>>& siteValues, const ParallelFor& parallel,
  const ProgressCallback& progress, std::vector<std::vector<double>>& functions) const
{
  functions.clear();
  const Implementation& internals = *this->Internals;
  DGG_RETURN_IF_ERROR(internals.Check());
  const std::size_t count = internals.Sites.size();
  if (atSites.size() != count * count)
  {
    return InvalidInput(
      "There are ", atSites.size(), " values of ", count, " functions at the same number of sites")
      .Fix("Give one value per function and site");
  }
  std::vector<SurfacePoint> places;
  for (const Id site : internals.Sites)
  {
    places.push_back(SurfacePoint::AtVertex(site));
  }
  const auto size = static_cast<Eigen::Index>(count);
  SiteEquations equations(internals.System);
  DGG_RETURN_IF_ERROR(ReportTo(progress, 0.0)); // factorizing takes long
  DGG_RETURN_IF_ERROR(
    equations.Prepare(places, Eigen::Map<const Eigen::MatrixXd>(atSites.data(), size, size)));
  return equations.Solve(
    siteValues,
    [&](std::vector<std::vector<double>>& columns) {
      for (std::vector<double>& column : columns)
      {
        std::vector<double> coefficients;
        coefficients.swap(column);
        DGG_RETURN_IF_ERROR(this->Combine(coefficients, {}, column));
      }
      return Status::Success();
    },
    parallel, progress, functions);
}
}
