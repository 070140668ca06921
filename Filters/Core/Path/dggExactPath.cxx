// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggExactPath.h"

#include "dggWindowTracer.h"

#include <algorithm>
#include <sstream>

namespace dgg
{
ExactPathFinder::ExactPathFinder(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , Fitness(CheckCorners(mesh))
  , Solver(std::make_unique<ExactGeodesics>(mesh))
{
}

ExactPathFinder::~ExactPathFinder() = default;

std::size_t ExactPathFinder::GetMemorySize() const
{
  const ExactResult& kept = this->Solver->GetKept();
  return this->MemorySize + kept.Distances.capacity() * sizeof(double) +
    kept.NearestSource.capacity() * sizeof(Id) + kept.Predecessors.capacity() * sizeof(Predecessor);
}

Status ExactPathFinder::Find(const SurfacePoint& from, const std::vector<SurfacePoint>& to,
  const ProgressCallback& progress, std::vector<SurfacePath>& paths, double maximumDistance)
{
  paths.clear();
  this->NumberOfWindows = 0;
  if (!this->Fitness.IsOk())
  {
    return this->Fitness;
  }
  ExactOptions options;
  options.Targets = to;
  options.StopAtTargets = true;
  options.MaximumDistance = maximumDistance;
  options.Progress = progress;
  Status status = this->Solver->RunKept({ { from, 0.0 } }, options);
  const ExactResult& result = this->Solver->GetKept();
  this->MemorySize = std::max(this->MemorySize, result.PeakMemory);
  if (!status.IsOk())
  {
    return status;
  }
  this->NumberOfWindows = result.NumberOfWindows;
  paths.resize(to.size());
  WindowTracer tracer(this->Mesh, from, result);
  for (std::size_t t = 0; t < to.size(); ++t)
  {
    const double distance = result.TargetDistances[t];
    if (distance < Infinity &&
      !tracer.Trace(to[t], distance, result.TargetPredecessors[t], paths[t]))
    {
      std::ostringstream message;
      message << "the path to target " << t << ", at distance " << distance
              << ", cannot be traced back: the faces that it crosses are too narrow";
      paths.clear();
      return Status::Invalid(message.str());
    }
  }
  return Status::Success();
}
}
