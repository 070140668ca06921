// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGreensInterpolation.h"

#include "dggGeodesicSource.h"
#include "dggGreensColumn.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace dgg
{
namespace
{
/// Progress after the columns of vertices, and weight of the last step after the distances from the
/// pole.
constexpr double ColumnsDone = 0.6;
constexpr double LastPart = 0.1;
}

/// Cache of the regular parts of vertices.
class GreensInterpolation::Cache
{
public:
  explicit Cache(const PoissonSolver& solver)
    : Function(solver)
    , Workspace(solver.GetSystem())
    , Column(solver.GetSystem())
  {
  }

  /// Finds the regular part of a vertex for a radius. The pointer is valid until three other
  /// vertices have been requested.
  Status Find(const PoissonSystem& system, Id v, const GreensQuery& query,
    const ProgressCallback& progress, const std::vector<float>*& values)
  {
    const Key key(v, query.Radius);
    const auto found = this->Columns.find(key);
    if (found != this->Columns.end())
    {
      found->second.LastUse = ++this->Uses;
      values = &found->second.Values;
      return Status::Success();
    }
    GreensQuery plain;
    plain.Radius = query.Radius;
    DGG_RETURN_IF_ERROR(
      this->Column.Start(SurfacePoint::AtVertex(v), plain, progress, this->Workspace));
    std::vector<double> solution = this->Column.TakeSources();
    system.Solve(solution);
    ++this->NumberOfColumns;
    const Id component = system.GetComponent(v);
    std::vector<float> part(solution.size());
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      const bool isHere = system.GetComponent(static_cast<Id>(i)) == component;
      part[i] = static_cast<float>(solution[i] - (isHere ? this->Column.GetMean() : 0.0));
    }
    this->Shrink(1);
    Entry& entry = this->Columns[key];
    entry = { std::move(part), ++this->Uses };
    values = &entry.Values;
    return Status::Success();
  }

  std::size_t GetMemorySize(std::size_t more = 0) const
  {
    return this->Columns.empty()
      ? 0
      : (this->Columns.size() + more) * this->Columns.begin()->second.Values.size() * sizeof(float);
  }

  /// Discards columns of an outdated system, and columns beyond the limit.
  void Update(const PoissonSystem& system, std::size_t memoryLimit)
  {
    this->MemoryLimit = memoryLimit;
    if (this->Revision != system.GetRevision())
    {
      this->Columns.clear();
      this->Revision = system.GetRevision();
    }
    this->Shrink(0);
  }

  GreensFunction Function; ///< used where columns of vertices are not applicable
  GreensWorkspace Workspace;
  GreensColumn Column;
  Id NumberOfColumns = 0;

private:
  using Key = std::pair<Id, double>;
  struct Entry
  {
    std::vector<float> Values;
    std::uint64_t LastUse = 0;
  };

  /// Frees memory for additional columns by discarding the least recently used ones. Keeps at least
  /// three columns in total.
  void Shrink(std::size_t more)
  {
    while (this->Columns.size() + more > 3 && this->GetMemorySize(more) > this->MemoryLimit)
    {
      this->Columns.erase(std::min_element(this->Columns.begin(), this->Columns.end(),
        [](const auto& a, const auto& b) { return a.second.LastUse < b.second.LastUse; }));
    }
  }

  std::uint64_t Revision = 0; // revision of the system of the columns
  std::size_t MemoryLimit = 0;
  std::uint64_t Uses = 0;
  std::map<Key, Entry> Columns;
};

GreensInterpolation::GreensInterpolation(const PoissonSolver& solver, std::size_t memoryLimit)
  : Solver(solver)
  , MemoryLimit(memoryLimit)
  , Columns(std::make_unique<Cache>(solver))
{
}

GreensInterpolation::~GreensInterpolation() = default;

Status GreensInterpolation::Run(
  const SurfacePoint& pole, const GreensQuery& query, GreensResult& result)
{
  result = GreensResult();
  GreensQuery same = GetFirstQuery(query);
  same.Method = GreensMethod::SingularitySubtraction;
  DGG_RETURN_IF_ERROR(CheckGreensQuery(this->Solver, same));
  DGG_RETURN_IF_ERROR(this->Solver.CheckPole(pole));
  const PoissonSystem& system = this->Solver.GetSystem();
  const SurfaceMesh& mesh = system.GetMesh();
  this->Columns->Update(system, this->MemoryLimit);
  const Id component = system.GetComponent(pole);
  // Runs GreensFunction, if columns of vertices are not applicable.
  const auto runFunction = [&](double begin) {
    GreensQuery other = query;
    other.Method = GreensMethod::SingularitySubtraction;
    other.Progress = ProgressPart(query.Progress, begin, 1.0);
    return this->Columns->Function.Run(pole, other, result);
  };
  bool isCoarse = false;
  if (!(same.Radius > 0.0))
  {
    isCoarse = GreensColumn::HasLargeTriangles(system, component);
    same.Radius = GreensColumn::GetUsualRadius(system, component);
  }
  std::vector<std::pair<Id, double>> corners;
  bool isFree = true;
  ForEachCornerAround(mesh, pole, [&](Id v, double weight, double) {
    if (weight > 0.0)
    {
      corners.emplace_back(v, weight);
      isFree = isFree && !system.IsFixed(v);
    }
  });
  if (!isFree || isCoarse || GreensColumn::IsTooCoarse(system, component, same.Radius))
  {
    return runFunction(0.0);
  }
  std::vector<double> regular(system.GetNumberOfVertices(), 0.0);
  const double part = ColumnsDone / static_cast<double>(corners.size());
  double done = 0.0;
  for (const auto& [v, weight] : corners)
  {
    const std::vector<float>* values = nullptr;
    DGG_RETURN_IF_ERROR(this->Columns->Find(
      system, v, same, ProgressPart(query.Progress, done, done + part), values));
    done += part;
    DGG_RETURN_IF_ERROR(ReportTo(query.Progress, done));
    for (std::size_t i = 0; i < regular.size(); ++i)
    {
      regular[i] += weight * static_cast<double>((*values)[i]);
    }
  }
  GreensColumn& column = this->Columns->Column;
  DGG_RETURN_IF_ERROR(column.Start(pole, same,
    ProgressPart(query.Progress, ColumnsDone, 1.0 - LastPart), this->Columns->Workspace));
  if (!column.HasLogarithm()) // the triangle of the pole was not found
  {
    return runFunction(1.0 - LastPart);
  }
  column.AddLogarithm(regular, result);
  if (query.Order == GreensOrder::BiLaplace)
  {
    DGG_RETURN_IF_ERROR(ReportTo(query.Progress, 1.0 - LastPart));
    RaiseOrder(system, query, { column }, &result);
  }
  Status status = ReportTo(query.Progress, 1.0);
  if (!status.IsOk())
  {
    result = GreensResult();
  }
  return status;
}

Id GreensInterpolation::GetNumberOfColumns() const
{
  return this->Columns->NumberOfColumns;
}

std::size_t GreensInterpolation::GetMemorySize() const
{
  return this->Columns->GetMemorySize();
}
}
