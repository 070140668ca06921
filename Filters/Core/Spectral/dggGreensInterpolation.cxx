// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGreensInterpolation.h"

#include "dggGeodesicSource.h"
#include "dggGreensColumn.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <map>
#include <utility>

namespace dgg
{
/// Regular parts of vertices, those used last in front.
class GreensInterpolation::Cache
{
public:
  Cache(const PoissonSolver& solver, std::size_t memoryLimit)
    : Function(solver)
    , Workspace(solver.GetSystem())
    , Column(solver.GetSystem())
    , MemoryLimit(memoryLimit)
  {
  }

  /// Regular part of a vertex, for a radius; valid until three others have been asked for.
  Status Find(
    const PoissonSystem& system, Id v, const GreensQuery& query, const std::vector<float>*& values)
  {
    const auto key = std::make_pair(v, query.Radius);
    const auto found = this->Places.find(key);
    if (found != this->Places.end())
    {
      this->Entries.splice(this->Entries.begin(), this->Entries, found->second);
      values = &found->second->second;
      return Status::Success();
    }
    GreensQuery plain;
    plain.Radius = query.Radius;
    plain.Progress = query.Progress;
    Status status = this->Column.Start(SurfacePoint::AtVertex(v), plain, this->Workspace);
    if (!status.IsOk())
    {
      return status;
    }
    std::vector<double> solution = this->Column.GetSources();
    system.Solve(solution);
    ++this->NumberOfColumns;
    const Id component = system.GetComponent(v);
    std::vector<float> part(solution.size());
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      const bool isHere = system.GetComponent(static_cast<Id>(i)) == component;
      part[i] = static_cast<float>(solution[i] - (isHere ? this->Column.GetMean() : 0.0));
    }
    const std::size_t size = part.size() * sizeof(float);
    while (this->Entries.size() > 2 && (this->Entries.size() + 1) * size > this->MemoryLimit)
    {
      this->Places.erase(this->Entries.back().first);
      this->Entries.pop_back();
    }
    this->Entries.emplace_front(key, std::move(part));
    this->Places[key] = this->Entries.begin();
    values = &this->Entries.front().second;
    return status;
  }

  std::size_t GetMemorySize() const
  {
    return this->Entries.empty()
      ? 0
      : this->Entries.size() * this->Entries.front().second.size() * sizeof(float);
  }

  GreensFunction Function; ///< where columns of vertices will not do
  GreensWorkspace Workspace;
  GreensColumn Column;
  Id NumberOfColumns = 0;

private:
  using Key = std::pair<Id, double>;

  std::size_t MemoryLimit;
  std::list<std::pair<Key, std::vector<float>>> Entries;
  std::map<Key, std::list<std::pair<Key, std::vector<float>>>::iterator> Places;
};

GreensInterpolation::GreensInterpolation(const PoissonSolver& solver, std::size_t memoryLimit)
  : Solver(solver)
  , Columns(std::make_unique<Cache>(solver, memoryLimit))
{
}

GreensInterpolation::~GreensInterpolation() = default;

Status GreensInterpolation::Run(
  const SurfacePoint& pole, const GreensQuery& query, GreensResult& result)
{
  result = GreensResult();
  GreensQuery same = query;
  same.Method = GreensMethod::SingularitySubtraction;
  Status status = CheckGreensQuery(this->Solver, same);
  status = status.IsOk() ? this->Solver.CheckPole(pole) : status;
  if (!status.IsOk())
  {
    return status;
  }
  const PoissonSystem& system = this->Solver.GetSystem();
  const SurfaceMesh& mesh = system.GetMesh();
  const Id component =
    system.GetComponent(IsVertex(pole) ? pole.Vertex : mesh.Origin(3 * pole.Face));
  if (!(same.Radius > 0.0))
  {
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
  if (!isFree || GreensColumn::IsTooCoarse(system, component, same.Radius))
  {
    return this->Columns->Function.Run(pole, query, result);
  }
  std::vector<double> regular(system.GetNumberOfVertices(), 0.0);
  for (const auto& [v, weight] : corners)
  {
    const std::vector<float>* values = nullptr;
    status = this->Columns->Find(system, v, same, values);
    if (!status.IsOk())
    {
      return status;
    }
    for (std::size_t i = 0; i < regular.size(); ++i)
    {
      regular[i] += weight * static_cast<double>((*values)[i]);
    }
  }
  GreensColumn& column = this->Columns->Column;
  status = column.Start(pole, same, this->Columns->Workspace);
  if (!status.IsOk())
  {
    return status;
  }
  if (!column.HasLogarithm())
  {
    return this->Columns->Function.Run(pole, query, result);
  }
  column.AddLogarithm(regular, result);
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
