// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHarmonicSplines.h"

#include "dggBlockLoop.h"
#include "dggGeodesicSource.h"
#include "dggPoissonIntegral.h"
#include "dggPoissonSystem.h"
#include "dggSiteEquations.h"
#include "dggSplineCells.h"
#include "dggSplineSites.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace dgg
{
namespace
{
constexpr int Lanes = SparseLanes::SizeAtCompileTime;
/// Part of the progress of a few functions when they are solved for.
constexpr double SolvedAt = 0.8;
/// Larger sources may overflow when they are summed and multiplied by conductances.
constexpr double LargestSource = 1e290;
using Entries = Eigen::SparseMatrix<double>::InnerIterator;
}

class HarmonicSplines::Implementation
{
public:
  explicit Implementation(const PoissonSolver& solver)
    : Solver(solver)
    , System(solver.GetSystem())
    , Integral(solver)
  {
  }

  Id GetNumberOfSites() const { return static_cast<Id>(this->Sites.size()); }

  Status Check() const
  {
    if (this->Sites.empty())
    {
      return Status::Invalid("there are no sites: call Prepare() first");
    }
    return this->Revision == this->System.GetRevision()
      ? Status::Success()
      : Status::Invalid("the solver has been prepared anew: call Prepare() again");
  }

  /// The part of a vertex in what its cell gives off.
  double ShareOf(Id v) const
  {
    return this->System.GetWeight(v) / this->Cells.Weights[this->Cells.Cells[v]];
  }

  /// Mean of a basis function; 0 where values are given.
  double MeanOf(Id site) const
  {
    return this->System.IsFree(this->Cells.Components[site]) ? this->Cells.Weights[site] : 0.0;
  }

  /// Sources of cells, spread over their vertices, and the solution for these. `Number` is double
  /// or SparseLanes.
  template <typename Number>
  void SolveForCells(
    const std::vector<Number>& charges, const Number& zero, std::vector<Number>& values) const
  {
    const Id n = this->System.GetNumberOfVertices();
    for (Id v = 0; v < n; ++v)
    {
      if (this->Cells.Cells[v] != NoId)
      {
        values[v] = charges[this->Cells.Cells[v]] * this->ShareOf(v);
      }
      else if (!this->System.IsFixed(v))
      {
        values[v] = zero;
      }
    }
    this->System.Solve(values);
  }

  /// Solve for a function of each site, from sources per cell: `setCharges(site, charges, lane)`.
  Status SolveForSites(
    const ParallelFor& parallel, const ProgressCallback& progress, const Consumer& consume) const
  {
    Status status = this->Check();
    if (!status.IsOk())
    {
      return status;
    }
    const auto n = static_cast<std::size_t>(this->System.GetNumberOfVertices());
    const SparseLanes zero = SparseLanes::Zero();
    const auto runBlock = [&](Offset, Offset begin, Offset end, const ProgressCallback& within) {
      std::vector<SparseLanes> charges(this->Sites.size(), zero);
      std::vector<SparseLanes> solutions(n, zero);
      for (Offset site = begin; site < end; ++site)
      {
        for (Entries entry(this->Cells.Stiffness, site); entry; ++entry)
        {
          charges[entry.row()][site - begin] = entry.value();
        }
      }
      this->SolveForCells(charges, zero, solutions);
      if (!within(SolvedAt))
      {
        return Status::Abort();
      }
      std::vector<double> values(n);
      for (Offset site = begin; site < end; ++site)
      {
        const Id component = this->Cells.Components[site];
        const double mean = this->MeanOf(static_cast<Id>(site));
        for (std::size_t v = 0; v < n; ++v)
        {
          const bool isHere = this->System.GetComponent(static_cast<Id>(v)) == component;
          values[v] = isHere ? mean + solutions[v][site - begin] : 0.0;
        }
        consume(static_cast<Id>(site), values);
      }
      return Status::Success();
    };
    return ForBlocks(static_cast<Offset>(this->Sites.size()), Lanes, parallel, progress, runBlock);
  }

  const PoissonSolver& Solver;
  const PoissonSystem& System;
  PoissonIntegral Integral;
  std::vector<Id> Sites;
  SplineCells Cells;
  std::uint64_t Revision = 0; // of the system that the cells were made for
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
  if (!internals.Solver.IsReady())
  {
    return Status::Invalid("the solver has not been prepared: call Prepare() first");
  }
  if (sites.empty())
  {
    return Status::Invalid("there is no site: give one at least");
  }
  Status status = CheckSplineSites(internals.Solver, sites);
  if (status.IsOk())
  {
    status = FindSplineCells(internals.System, sites, parallel, progress, internals.Cells);
  }
  if (status.IsOk())
  {
    internals.Sites = sites;
    internals.Revision = internals.System.GetRevision();
  }
  return status;
}

const std::vector<Id>& HarmonicSplines::GetSites() const
{
  return this->Internals->Sites;
}

const std::vector<Id>& HarmonicSplines::GetCells() const
{
  return this->Internals->Cells.Cells;
}

double HarmonicSplines::GetCellArea(Id site) const
{
  return this->Internals->Cells.Areas[site];
}

double HarmonicSplines::GetCellWeight(Id site) const
{
  return this->Internals->Cells.Weights[site];
}

double HarmonicSplines::GetCoefficient(Id i, Id j) const
{
  return this->Internals->Cells.Stiffness.coeff(i, j);
}

Status HarmonicSplines::FindBasis(
  const ParallelFor& parallel, const ProgressCallback& progress, const Consumer& consume) const
{
  return this->Internals->SolveForSites(parallel, progress, consume);
}

Status HarmonicSplines::Evaluate(const std::vector<SurfacePoint>& points, GreensMethod method,
  const ParallelFor& parallel, const ProgressCallback& progress, std::vector<double>& values) const
{
  values.clear();
  const Implementation& internals = *this->Internals;
  Status status = internals.Check();
  if (!status.IsOk())
  {
    return status;
  }
  const std::size_t count = internals.Sites.size();
  const PoissonSystem& system = internals.System;
  std::vector<double> found(points.size() * count, 0.0);
  status = internals.Integral.ForEachPoint(
    points, method, parallel, progress, [&](std::size_t k, const std::vector<double>& greens) {
      const Id component = system.GetComponent(points[k]);
      std::vector<double> means(count, 0.0); // of the Green's function, over the cells
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
    });
  for (std::size_t k = 0; k < points.size() && status.IsOk(); ++k)
  {
    const Id component = system.GetComponent(points[k]);
    const bool isPassedOver = system.IsThin(component) && system.IsFree(component);
    for (std::size_t j = 0; j < count && isPassedOver; ++j)
    {
      // There is a single site, see CheckSplineSites(), whose function is 1.
      found[k * count + j] = internals.Cells.Components[j] == component ? 1.0 : 0.0;
    }
  }
  if (status.IsOk())
  {
    values.swap(found);
  }
  return status;
}

Status HarmonicSplines::Solve(const std::vector<double>& rightHandSide,
  const std::vector<Id>& given, std::vector<double>& coefficients) const
{
  const Implementation& internals = *this->Internals;
  Status status = internals.Check();
  status = status.IsOk() ? internals.Solver.CheckValues(rightHandSide) : status;
  if (!status.IsOk())
  {
    return status;
  }
  const Id count = internals.GetNumberOfSites();
  SiteEquations equations(internals.System, internals.Cells, rightHandSide);
  for (const Id site : given)
  {
    if (site < 0 || site >= count || coefficients.size() != static_cast<std::size_t>(count) ||
      !std::isfinite(coefficients[site]))
    {
      return Status::Invalid("there is no finite value for the given site " + std::to_string(site) +
        " of " + std::to_string(count));
    }
    equations.Give(site, coefficients[site]);
  }
  std::vector<double> solution;
  if (!equations.Solve(solution))
  {
    const bool isHuge = std::any_of(rightHandSide.begin(), rightHandSide.end(),
      [](double f) { return std::abs(f) > LargestSource; });
    return Status::Invalid(std::string("the equations of the sites could not be solved: ") +
      (isHuge ? "the right-hand side has values above 1e290, divide it by a number"
              : "some cells do not conduct, choose other sites or flip edges (IntrinsicDelaunay)"));
  }
  coefficients.swap(solution);
  return status;
}

Status HarmonicSplines::Combine(const std::vector<double>& coefficients,
  const std::vector<double>& givenValues, std::vector<double>& values) const
{
  values.clear();
  const Implementation& internals = *this->Internals;
  const PoissonSystem& system = internals.System;
  const SplineCells& cells = internals.Cells;
  Status status = internals.Check();
  status =
    status.IsOk() && !givenValues.empty() ? internals.Solver.CheckNumbers(givenValues) : status;
  if (status.IsOk() && coefficients.size() != internals.Sites.size())
  {
    status = Status::Invalid("there are " + std::to_string(coefficients.size()) +
      " coefficients for " + std::to_string(internals.Sites.size()) + " sites: give one for each");
  }
  if (!status.IsOk())
  {
    return status;
  }
  std::vector<double> means(system.GetNumberOfComponents(), 0.0);
  std::vector<double> charges(coefficients.size(), 0.0);
  for (Id j = 0; j < internals.GetNumberOfSites(); ++j)
  {
    means[cells.Components[j]] += internals.MeanOf(j) * coefficients[j];
    // Differences, so that constants give 0 to the last bit.
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
  internals.SolveForCells(charges, 0.0, values);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    values[v] += cells.Cells[v] == NoId ? 0.0 : means[system.GetComponent(v)];
  }
  return status;
}
}
