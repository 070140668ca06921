// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGreensFunction.h"

#include "dggGreensColumn.h"
#include "dggProgressPart.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <utility>

namespace dgg
{
namespace
{
static_assert(
  SparseLanes::SizeAtCompileTime == GreensFunction::PolesInBlock, "a block is solved for at once");
/// Progress after distances and loads, after the solve, and after the evaluation; the remainder is
/// for a second solve.
constexpr double StartDone = 0.6;
constexpr double SolveDone = 0.8;
constexpr double FinishDone = 0.9;
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
  DGG_RETURN_IF_ERROR(CheckGreensQuery(this->Solver, query));
  DGG_RETURN_IF_ERROR(this->Solver.CheckPole(pole));
  std::vector<GreensResult> results(1);
  DGG_RETURN_IF_ERROR(this->RunBlock({ pole }, 0, 1, query, query.Progress, results));
  result = std::move(results[0]);
  return Status::Success();
}

Status GreensFunction::Run(const std::vector<SurfacePoint>& poles, const GreensQuery& query,
  std::vector<GreensResult>& results) const
{
  results.clear();
  DGG_RETURN_IF_ERROR(CheckGreensQuery(this->Solver, query));
  for (std::size_t k = 0; k < poles.size(); ++k)
  {
    DGG_RETURN_IF_ERROR(this->Solver.CheckPole(poles[k]).Of(JoinText("Pole ", k)));
  }
  Status status;
  results.resize(poles.size());
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
  const GreensQuery firstQuery = GetFirstQuery(query);
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
    DGG_RETURN_IF_ERROR(columns[k].Start(poles[first + k], firstQuery, part, *workspace));
    DGG_RETURN_IF_ERROR(ReportTo(part, 1.0));
    solutions[k] = columns[k].TakeSources();
  }
  system.Solve(solutions);
  DGG_RETURN_IF_ERROR(ReportTo(progress, SolveDone));
  const bool isRaised = query.Order == GreensOrder::BiLaplace;
  const double finished = isRaised ? FinishDone : 1.0;
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    DGG_RETURN_IF_ERROR(columns[k].Finish(
      solutions[k], partOf(k, SolveDone, finished), *workspace, results[first + k]));
  }
  if (isRaised)
  {
    DGG_RETURN_IF_ERROR(ReportTo(progress, FinishDone));
    RaiseOrder(system, query, columns, results.data() + first);
  }
  return ReportTo(progress, 1.0);
}
}
