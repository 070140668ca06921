// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPoissonIntegral.h"

#include "dggBlockLoop.h"
#include "dggGeodesicSource.h"
#include "dggGreensColumn.h"
#include "dggPoissonSystem.h"
#include "dggProgressPart.h"

#include <string>

namespace dgg
{
namespace
{
/// Part of the progress when harmonic functions are known.
constexpr double HarmonicDone = 0.1;

/// Whether all corners that matter to a point have given values.
bool IsGiven(const PoissonSystem& system, const SurfacePoint& point)
{
  bool isGiven = true;
  ForEachCornerAround(system.GetMesh(), point, [&](Id v, double weight, double) {
    isGiven = isGiven && (!(weight > 0.0) || system.IsFixed(v));
  });
  return isGiven;
}

/// Whether a point lies in a thin component without given values.
bool IsInThinPart(const PoissonSystem& system, const SurfacePoint& point)
{
  const Id c = system.GetComponent(point);
  return system.IsThin(c) && system.IsFree(c);
}

bool HasGivenValues(const PoissonSystem& system)
{
  bool has = false;
  for (Id v = 0; v < system.GetNumberOfVertices() && !has; ++v)
  {
    has = system.IsFixed(v);
  }
  return has;
}
}

PoissonIntegral::PoissonIntegral(const PoissonSolver& solver)
  : Solver(solver)
  , Function(solver)
{
}

Status PoissonIntegral::ForEachPoint(const std::vector<SurfacePoint>& points, GreensMethod method,
  const ParallelFor& parallel, const ProgressCallback& progress, const PointVisitor& visit) const
{
  if (!this->Solver.IsReady())
  {
    return Status::Invalid("the solver has not been prepared: call Prepare() first");
  }
  const PoissonSystem& system = this->Solver.GetSystem();
  const auto n = static_cast<std::size_t>(system.GetNumberOfVertices());
  std::vector<std::size_t> free; // of the points, those with a Green's function
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    Status status = points[k].Check(system.GetMesh());
    if (status.IsOk() && (IsGiven(system, points[k]) || IsInThinPart(system, points[k])))
    {
      continue;
    }
    status = status.IsOk() ? this->Solver.CheckPole(points[k]) : status;
    if (!status.IsOk())
    {
      return Status::Invalid("point " + std::to_string(k) + ": " + status.GetMessage());
    }
    free.push_back(k);
  }
  constexpr Offset BlockSize = GreensFunction::PolesInBlock;
  const auto count = static_cast<Offset>(free.size());
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
    Status status = this->Function.Run(poles, query, results);
    for (std::size_t k = 0; k < results.size() && status.IsOk(); ++k)
    {
      std::vector<double>& greens = results[k].Integrals;
      for (std::size_t v = 0; v < n; ++v)
      {
        const Id id = static_cast<Id>(v);
        const double area = system.GetArea(id);
        greens[v] = area > 0.0 && !system.IsFixed(id) ? greens[v] / area : 0.0;
      }
      visit(free[begin + static_cast<Offset>(k)], greens);
    }
    return status;
  };
  return ForBlocks(count, BlockSize, parallel, progress, runBlock);
}

Status PoissonIntegral::Run(const std::vector<SurfacePoint>& points,
  const std::vector<std::vector<double>>& rightHandSides, GreensMethod method,
  const ParallelFor& parallel, const ProgressCallback& progress,
  std::vector<std::vector<double>>& solutions) const
{
  solutions.clear();
  const PoissonSystem& system = this->Solver.GetSystem();
  const auto n = static_cast<std::size_t>(system.GetNumberOfVertices());
  std::vector<std::vector<double>> found(
    rightHandSides.size(), std::vector<double>(points.size(), 0.0));
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    Status status = points[k].Check(system.GetMesh());
    if (status.IsOk() && this->Solver.IsReady() && IsInThinPart(system, points[k]))
    {
      status = this->Solver.CheckPole(points[k]);
    }
    if (!status.IsOk())
    {
      return Status::Invalid("point " + std::to_string(k) + ": " + status.GetMessage());
    }
  }
  const bool hasGiven = this->Solver.IsReady() && HasGivenValues(system);
  for (std::size_t r = 0; r < rightHandSides.size(); ++r)
  {
    const Status status = this->Solver.CheckValues(rightHandSides[r]);
    if (!status.IsOk())
    {
      return Status::Invalid("right-hand side " + std::to_string(r) + ": " + status.GetMessage());
    }
    if (hasGiven)
    {
      std::vector<double> harmonic(n, 0.0);
      for (std::size_t v = 0; v < n; ++v)
      {
        harmonic[v] = system.IsFixed(static_cast<Id>(v)) ? rightHandSides[r][v] : 0.0;
      }
      system.Solve(harmonic);
      for (std::size_t k = 0; k < points.size(); ++k)
      {
        found[r][k] = InterpolateAt(system.GetMesh(), points[k], harmonic);
      }
    }
    const double done = static_cast<double>(r + 1) / static_cast<double>(rightHandSides.size());
    if (progress && !progress(HarmonicDone * done))
    {
      return Status::Abort();
    }
  }
  Status status =
    this->ForEachPoint(points, method, parallel, ProgressPart(progress, HarmonicDone, 1.0),
      [&](std::size_t point, const std::vector<double>& greens) {
        for (std::size_t r = 0; r < rightHandSides.size(); ++r)
        {
          double sum = 0.0;
          for (std::size_t v = 0; v < n; ++v)
          {
            sum += greens[v] * rightHandSides[r][v];
          }
          found[r][point] += sum;
        }
      });
  if (status.IsOk())
  {
    solutions.swap(found);
  }
  return status;
}
}
