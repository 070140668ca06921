// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGreensFunction.h"

#include "dggGreensColumn.h"
#include "dggProgressPart.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <string>
#include <utility>

namespace dgg
{
namespace
{
static_assert(
  SparseLanes::SizeAtCompileTime == GreensFunction::PolesInBlock, "a block is solved for at once");
/// Parts of the progress: distances and loads, the solve, what is made of it.
constexpr double StartDone = 0.6;
constexpr double SolveDone = 0.8;
}

class GreensFunction::Workspaces : public WorkspacePool<GreensWorkspace>
{
};

GreensFunction::GreensFunction(const PoissonSolver& solver)
  : Solver(solver)
  , Pool(std::make_unique<Workspaces>())
{
}

GreensFunction::~GreensFunction() = default;

Status GreensFunction::Run(
  const SurfacePoint& pole, const GreensQuery& query, GreensResult& result) const
{
  result = GreensResult();
  Status status = CheckGreensQuery(this->Solver, query);
  status = status.IsOk() ? this->Solver.CheckPole(pole) : status;
  std::vector<GreensResult> results(1);
  status = status.IsOk() ? this->RunBlock({ pole }, 0, 1, query, query.Progress, results) : status;
  if (status.IsOk())
  {
    result = std::move(results[0]);
  }
  return status;
}

Status GreensFunction::Run(const std::vector<SurfacePoint>& poles, const GreensQuery& query,
  std::vector<GreensResult>& results) const
{
  results.clear();
  Status status = CheckGreensQuery(this->Solver, query);
  for (std::size_t k = 0; k < poles.size() && status.IsOk(); ++k)
  {
    status = this->Solver.CheckPole(poles[k]);
    if (!status.IsOk())
    {
      return Status::Invalid("pole " + std::to_string(k) + ": " + status.GetMessage());
    }
  }
  results.resize(status.IsOk() ? poles.size() : 0);
  const auto count = static_cast<double>(poles.size());
  for (std::size_t first = 0; first < results.size() && status.IsOk(); first += PolesInBlock)
  {
    const std::size_t end = std::min<std::size_t>(poles.size(), first + PolesInBlock);
    status = this->RunBlock(poles, first, end, query,
      ProgressPart(
        query.Progress, static_cast<double>(first) / count, static_cast<double>(end) / count),
      results);
  }
  if (!status.IsOk())
  {
    results.clear();
  }
  return status;
}

Status GreensFunction::RunBlock(const std::vector<SurfacePoint>& poles, std::size_t first,
  std::size_t end, const GreensQuery& query, const ProgressCallback& progress,
  std::vector<GreensResult>& results) const
{
  const PoissonSystem& system = this->Solver.GetSystem();
  const auto workspace = this->Pool->Borrow(system);
  std::vector<GreensColumn> columns(end - first, GreensColumn(system));
  std::vector<std::vector<double>> solutions(columns.size());
  const auto partOf = [&](std::size_t k, double begin, double finish) {
    const auto count = static_cast<double>(columns.size());
    const double part = (finish - begin) / count;
    const auto done = static_cast<double>(k);
    return ProgressPart(
      progress, begin + part * done, k + 1 < columns.size() ? begin + part * (done + 1.0) : finish);
  };
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    const ProgressCallback part = partOf(k, 0.0, StartDone);
    const Status status = columns[k].Start(poles[first + k], query, part, *workspace);
    if (!status.IsOk() || !Goes(part, 1.0))
    {
      return status.IsOk() ? Status::Abort() : status;
    }
    solutions[k] = columns[k].TakeSources();
  }
  system.Solve(solutions);
  if (!Goes(progress, SolveDone))
  {
    return Status::Abort();
  }
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    const Status status =
      columns[k].Finish(solutions[k], partOf(k, SolveDone, 1.0), *workspace, results[first + k]);
    if (!status.IsOk())
    {
      return status;
    }
  }
  return Goes(progress, 1.0) ? Status::Success() : Status::Abort();
}
}
