// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGreensTask.h"

#include "dggBlockLoop.h"
#include "dggCounted.h"
#include "dggStatus.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace dgg
{
namespace
{
constexpr std::size_t BlockSize = GreensFunction::PolesInBlock;

/// Reasons why another method than the requested one was used.
const std::pair<GreensRemark, const char*> Remarks[] = {
  { GreensRemark::TooCoarse,
    "the mesh is too coarse around them for the method, so Interpolated was used. Refine the mesh "
    "there, or set {Radius}" },
  { GreensRemark::NoTriangle,
    "they were not found on the flipped mesh, so Interpolated was used. Turn off "
    "{IntrinsicDelaunay}" },
  { GreensRemark::NotLocalized,
    "the boundary or long triangles are too close to them for the method, so Interpolated was "
    "used" }
};
}

//------------------------------------------------------------------------------
double GreensTask::EstimateMemory(const TaskContext& context, const PoissonSolver& solver,
  std::size_t numberOfSources, std::size_t numberOfTargets) const
{
  const std::size_t blocks = (numberOfSources + BlockSize - 1) / BlockSize;
  const auto threads = static_cast<std::size_t>(context.NumberOfThreads);
  return static_cast<double>(std::min(threads, blocks)) *
    (GreensFunction::BytesPerVertex * static_cast<double>(solver.GetAreas().size()) +
      GreensFunction::BytesPerTarget * static_cast<double>(numberOfTargets));
}

//------------------------------------------------------------------------------
Status GreensTask::Compute(const SpectralRun& run)
{
  if (this->SolverNumber != run.SolverNumber)
  {
    this->Function.emplace(run.Solver);
    this->Columns.emplace(run.Solver);
    this->SolverNumber = run.SolverNumber;
  }
  for (std::size_t k = 0; k < run.Sources.size(); ++k)
  {
    DGG_RETURN_IF_ERROR(run.Solver.CheckPole(run.Sources[k]).Of(JoinText("Source ", k)));
  }
  GreensQuery query = this->Query;
  query.Targets = run.Targets;
  this->Used.assign(run.Sources.size(), UsedMethod());
  const Status status =
    this->IsInterpolated ? this->RunOneByOne(run, query) : this->RunBlocks(run, query);
  if (!status.IsOk())
  {
    this->Forget();
    return status;
  }
  this->Warn(run.Warnings);
  return status;
}

//------------------------------------------------------------------------------
/// Runs blocks of sources, several of them simultaneously.
Status GreensTask::RunBlocks(const SpectralRun& run, const GreensQuery& query)
{
  return ForBlocks(static_cast<Offset>(run.Sources.size()), BlockSize, run.Context.Parallel,
    run.Progress, [&](Offset, Offset begin, Offset end, const ProgressCallback& progress) {
      GreensQuery own = query;
      own.Progress = progress;
      std::vector<GreensResult> results;
      const Status status = this->Function->Run(
        { run.Sources.begin() + begin, run.Sources.begin() + end }, own, results);
      for (std::size_t k = 0; k < results.size(); ++k)
      {
        this->Store(run, static_cast<std::size_t>(begin) + k, results[k]);
      }
      return status;
    });
}

//------------------------------------------------------------------------------
/// Runs sources in succession, since each reuses columns of earlier sources.
Status GreensTask::RunOneByOne(const SpectralRun& run, const GreensQuery& query)
{
  const double most = 0.5 * static_cast<double>(std::numeric_limits<std::size_t>::max());
  this->Columns->SetMemoryLimit(static_cast<std::size_t>(std::min(most, run.FreeMemory)));
  const auto count = static_cast<double>(run.Sources.size());
  for (std::size_t k = 0; k < run.Sources.size(); ++k)
  {
    const auto done = static_cast<double>(k);
    GreensQuery own = query;
    own.Progress = ProgressPart(run.Progress, done / count, (done + 1.0) / count);
    GreensResult result;
    DGG_RETURN_IF_ERROR(this->Columns->Run(run.Sources[k], own, result));
    this->Store(run, k, result);
  }
  return ReportTo(run.Progress, 1.0);
}

//------------------------------------------------------------------------------
void GreensTask::Store(const SpectralRun& run, std::size_t source, const GreensResult& result)
{
  run.Outputs.Set(run.Result, source, result.Values, result.TargetValues);
  this->Used[source] = { static_cast<int>(result.Method), result.Remark, result.Radius };
}

//------------------------------------------------------------------------------
void GreensTask::Warn(std::vector<std::string>& warnings) const
{
  for (const auto& [remark, text] : Remarks)
  {
    const auto has = [wanted = remark](const UsedMethod& used) { return used.Remark == wanted; };
    const auto count = std::count_if(this->Used.begin(), this->Used.end(), has);
    if (count > 0)
    {
      const auto first = std::find_if(this->Used.begin(), this->Used.end(), has);
      warnings.push_back(JoinText(count, " of ", Counted(this->Used.size(), "source"),
        ", the first of them ", first - this->Used.begin(), ": ", text));
    }
  }
}
}
