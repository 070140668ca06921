// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSpectralDistanceTask.h"

#include "dggProgressPart.h"
#include "dggTaskContext.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Progress after eigenvalues or solutions for all points, and after distances to evaluation
/// points.
constexpr double SpectrumDone = 0.6;
constexpr double TargetsDone = 0.7;
/// Memory of the search for eigenvalues, in functions per eigenvalue, and of an exact solve, in
/// numbers per point and thread.
constexpr double FunctionsPerEigenvalue = 3.0;
constexpr double NumbersPerThread = 24.0;

using PlaceCheck = Status (SpectralDistance::*)(const SurfacePoint&) const;

/// Checks all points before the long computations.
Status CheckAll(const SpectralDistance& distance, PlaceCheck check,
  const std::vector<SurfacePoint>& points, const std::string& name)
{
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    DGG_RETURN_IF_ERROR((distance.*check)(points[k]).Of(name + std::to_string(k)));
  }
  return Status::Success();
}
}

//------------------------------------------------------------------------------
int SpectralDistanceTask::GetNumberOfSpectra() const
{
  return this->EarlierSpectra + (this->Distance ? this->Distance->GetNumberOfSpectra() : 0);
}

//------------------------------------------------------------------------------
double SpectralDistanceTask::EstimateMemory(const TaskContext& context, const PoissonSolver& solver,
  std::size_t numberOfSources, std::size_t numberOfTargets) const
{
  const auto n = static_cast<double>(solver.GetAreas().size());
  const double count = std::min<double>(this->Options.NumberOfEigenvalues, n);
  const auto points =
    numberOfTargets > 0 ? static_cast<double>(numberOfSources + numberOfTargets) : 0.0;
  const double numbers = this->Options.Method == SpectralMethod::Exact
    ? n * (NumbersPerThread * context.NumberOfThreads + points)
    : count * (FunctionsPerEigenvalue * n + points);
  return numbers * sizeof(double);
}

//------------------------------------------------------------------------------
Status SpectralDistanceTask::Compute(const SpectralRun& run)
{
  if (this->SolverNumber != run.SolverNumber)
  {
    this->EarlierSpectra = this->GetNumberOfSpectra();
    this->Distance.emplace(run.Solver);
    this->SolverNumber = run.SolverNumber;
  }
  const std::vector<SurfacePoint>& targets = run.Targets;
  DGG_RETURN_IF_ERROR(
    CheckAll(*this->Distance, &SpectralDistance::CheckSource, run.Sources, "Source "));
  DGG_RETURN_IF_ERROR(
    CheckAll(*this->Distance, &SpectralDistance::CheckPlace, targets, "Evaluation point "));
  const ParallelFor& parallel = run.Context.Parallel;
  DGG_RETURN_IF_ERROR(this->Distance->Prepare(
    this->Options, parallel, ProgressPart(run.Progress, 0.0, SpectrumDone), run.Sources));
  std::vector<double> matrix; // between sources and targets, row by row
  if (!targets.empty())
  {
    DGG_RETURN_IF_ERROR(this->Distance->Between(run.Sources, targets, parallel,
      ProgressPart(run.Progress, SpectrumDone, TargetsDone), matrix));
  }
  const auto count = static_cast<double>(run.Sources.size());
  auto row = matrix.begin();
  for (std::size_t k = 0; k < run.Sources.size(); ++k)
  {
    std::vector<double> values;
    DGG_RETURN_IF_ERROR(this->Distance->FromPoint(run.Sources[k], values));
    const double done = static_cast<double>(k + 1) / count;
    DGG_RETURN_IF_ERROR(ReportTo(run.Progress, TargetsDone + (1.0 - TargetsDone) * done));
    const auto end = row + static_cast<std::ptrdiff_t>(targets.size());
    std::vector<double> targetValues(row, end);
    row = end;
    std::replace(values.begin(), values.end(), Infinity, this->UnreachedValue);
    std::replace(targetValues.begin(), targetValues.end(), Infinity, this->UnreachedValue);
    run.Outputs.Set(run.Result, k, values, targetValues);
  }
  return ReportTo(run.Progress, 1.0);
}
}
