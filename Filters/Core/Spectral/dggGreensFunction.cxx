// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGreensFunction.h"

#include "dggGreensColumn.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <mutex>
#include <string>

namespace dgg
{
namespace
{
constexpr Offset Lanes = SparseLanes::SizeAtCompileTime;
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
  status = column.Start(pole, query, *workspace);
  if (!status.IsOk())
  {
    return status;
  }
  std::vector<double> solution = column.GetSources();
  system.Solve(solution);
  return column.Finish(solution, *workspace, result);
}

Status GreensFunction::Run(const std::vector<SurfacePoint>& poles, const GreensQuery& query,
  const ParallelFor& parallel, std::vector<GreensResult>& results) const
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
  const PoissonSystem& system = this->Solver.GetSystem();
  const auto count = static_cast<Offset>(poles.size());
  results.resize(poles.size());
  std::mutex mutex;
  Offset done = 0;
  GreensQuery quiet = query;
  quiet.Progress = nullptr; // it is told here
  const auto note = [&](const Status& outcome) {
    const std::lock_guard<std::mutex> lock(mutex);
    status = status.IsOk() ? outcome : status;
  };
  ForRange(parallel, (count + Lanes - 1) / Lanes, 1, [&](Offset begin, Offset end) {
    const auto workspace = this->Pool->Borrow(system);
    std::vector<GreensColumn> columns(Lanes, GreensColumn(system));
    std::vector<SparseLanes> solutions(system.GetNumberOfVertices());
    std::vector<double> solution(solutions.size());
    for (Offset block = begin; block < end; ++block)
    {
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (status.IsOk() && query.Progress &&
          !query.Progress(static_cast<double>(done) / static_cast<double>(count)))
        {
          status = Status::Abort();
        }
        if (!status.IsOk())
        {
          return;
        }
      }
      const Offset first = block * Lanes;
      const Offset size = std::min(Lanes, count - first);
      std::fill(solutions.begin(), solutions.end(), SparseLanes(SparseLanes::Zero()));
      for (Offset k = 0; k < size; ++k)
      {
        const Status started = columns[k].Start(poles[first + k], quiet, *workspace);
        if (!started.IsOk())
        {
          note(started);
          return;
        }
        for (std::size_t v = 0; v < solutions.size(); ++v)
        {
          solutions[v][k] = columns[k].GetSources()[v];
        }
      }
      system.Solve(solutions);
      for (Offset k = 0; k < size; ++k)
      {
        solution.resize(solutions.size());
        for (std::size_t v = 0; v < solutions.size(); ++v)
        {
          solution[v] = solutions[v][k];
        }
        const Status finished = columns[k].Finish(solution, *workspace, results[first + k]);
        if (!finished.IsOk())
        {
          note(finished);
          return;
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      done += size;
    }
  });
  if (!status.IsOk())
  {
    results.clear();
  }
  return status;
}
}
