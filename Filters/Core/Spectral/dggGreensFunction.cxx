// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGreensFunction.h"

#include "dggGreensColumn.h"
#include "dggProgressPart.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <string>

namespace dgg
{
namespace
{
constexpr std::size_t Lanes = SparseLanes::SizeAtCompileTime;
static_assert(Lanes == GreensFunction::PolesInBlock, "blocks are as wide as lanes");
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
  if (!status.IsOk())
  {
    return status;
  }
  const PoissonSystem& system = this->Solver.GetSystem();
  const auto workspace = this->Pool->Borrow(system);
  GreensColumn column(system);
  status = column.Start(pole, query, ProgressPart(query.Progress, 0.0, StartDone), *workspace);
  if (!status.IsOk())
  {
    return status;
  }
  std::vector<double> solution = column.GetSources();
  system.Solve(solution);
  if (query.Progress && !query.Progress(SolveDone))
  {
    return Status::Abort();
  }
  status =
    column.Finish(solution, ProgressPart(query.Progress, SolveDone, 1.0), *workspace, result);
  if (status.IsOk() && query.Progress && !query.Progress(1.0))
  {
    status = Status::Abort();
  }
  if (!status.IsOk())
  {
    result = GreensResult();
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
      status = Status::Invalid("pole " + std::to_string(k) + ": " + status.GetMessage());
    }
  }
  if (!status.IsOk())
  {
    return status;
  }
  results.resize(poles.size());
  const auto count = static_cast<double>(poles.size());
  const auto workspace = this->Pool->Borrow(this->Solver.GetSystem());
  for (std::size_t first = 0; first < poles.size() && status.IsOk(); first += Lanes)
  {
    const std::size_t end = std::min(poles.size(), first + Lanes);
    status = this->RunBlock(poles, first, end, query,
      ProgressPart(
        query.Progress, static_cast<double>(first) / count, static_cast<double>(end) / count),
      *workspace, results);
  }
  if (!status.IsOk())
  {
    results.clear();
  }
  return status;
}

Status GreensFunction::RunBlock(const std::vector<SurfacePoint>& poles, std::size_t first,
  std::size_t end, const GreensQuery& query, const ProgressCallback& progress,
  GreensWorkspace& workspace, std::vector<GreensResult>& results) const
{
  const PoissonSystem& system = this->Solver.GetSystem();
  const auto n = static_cast<std::size_t>(system.GetNumberOfVertices());
  const auto count = static_cast<double>(end - first);
  std::vector<GreensColumn> columns(end - first, GreensColumn(system));
  std::vector<SparseLanes> solutions(n, SparseLanes(SparseLanes::Zero()));
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    const auto begin = static_cast<double>(k);
    Status status = columns[k].Start(poles[first + k], query,
      ProgressPart(progress, StartDone * begin / count, StartDone * (begin + 1.0) / count),
      workspace);
    if (status.IsOk() && progress && !progress(StartDone * (begin + 1.0) / count))
    {
      status = Status::Abort();
    }
    if (!status.IsOk())
    {
      return status;
    }
    for (std::size_t v = 0; v < n; ++v)
    {
      solutions[v][k] = columns[k].GetSources()[v];
    }
  }
  system.Solve(solutions);
  if (progress && !progress(SolveDone))
  {
    return Status::Abort();
  }
  std::vector<double> solution;
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    solution.resize(n);
    for (std::size_t v = 0; v < n; ++v)
    {
      solution[v] = solutions[v][k];
    }
    const auto begin = static_cast<double>(k);
    Status status = columns[k].Finish(solution,
      ProgressPart(progress, SolveDone + (1.0 - SolveDone) * begin / count,
        SolveDone + (1.0 - SolveDone) * (begin + 1.0) / count),
      workspace, results[first + k]);
    if (!status.IsOk())
    {
      return status;
    }
  }
  return progress && !progress(1.0) ? Status::Abort() : Status::Success();
}
}
