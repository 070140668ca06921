// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHeatMethod.h"

#include "dggDescent.h"
#include "dggHeatSystem.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dgg
{
namespace
{
/// A corner that a source heats.
struct Corner
{
  Id Source;
  Id Vertex;
  double Weight;
  double Distance; ///< straight, without the initial distance
};

std::vector<Corner> FindCorners(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources)
{
  std::vector<Corner> corners;
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    ForEachCornerAround(mesh, sources[k].Point, [&](Id v, double weight, double distance) {
      corners.push_back({ static_cast<Id>(k), v, weight, distance });
    });
  }
  return corners;
}

/// Heat of all sources. Initial distances count from the least one of the component.
std::vector<HeatSystem::Load> FindLoads(const HeatSystem& system,
  const std::vector<GeodesicSource>& sources, const std::vector<Corner>& corners,
  const std::vector<double>& leastOffsets)
{
  std::vector<HeatSystem::Load> loads;
  for (const Corner& corner : corners)
  {
    if (corner.Weight > 0.0)
    {
      const Id component = system.GetComponent(corner.Vertex);
      const double offset = sources[corner.Source].InitialDistance - leastOffsets[component];
      loads.push_back({ corner.Vertex, corner.Weight, -offset / system.GetHeatLength(component) });
    }
  }
  return loads;
}

/// What has to be added to the values of each component.
std::vector<double> FindShifts(const HeatSystem& system, const std::vector<GeodesicSource>& sources,
  const std::vector<Corner>& corners, const std::vector<double>& leastOffsets,
  const std::vector<double>& values)
{
  // What each source asks for.
  std::vector<double> wishes(sources.size());
  std::vector<Id> components(sources.size(), NoId);
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    wishes[k] = sources[k].InitialDistance;
  }
  for (const Corner& corner : corners)
  {
    components[corner.Source] = system.GetComponent(corner.Vertex);
    wishes[corner.Source] += corner.Weight * (corner.Distance - values[corner.Vertex]);
  }
  // A source with the least initial distance has its wish. Others may be closer to that one than
  // their initial distance says; then they ask for much more.
  const auto isLeast = [&](std::size_t k) {
    return sources[k].InitialDistance == leastOffsets[components[k]];
  };
  const auto n = static_cast<std::size_t>(system.GetNumberOfComponents());
  std::vector<double> limits(n, -Infinity);
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    if (isLeast(k))
    {
      limits[components[k]] =
        std::max(limits[components[k]], wishes[k] + system.GetHeatLength(components[k]));
    }
  }
  std::vector<double> sums(n, 0.0);
  std::vector<double> counts(n, 0.0);
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    if (isLeast(k) || wishes[k] <= limits[components[k]])
    {
      sums[components[k]] += wishes[k];
      counts[components[k]] += 1.0;
    }
  }
  for (std::size_t c = 0; c < n; ++c)
  {
    sums[c] = counts[c] > 0.0 ? sums[c] / counts[c] : Infinity;
  }
  return sums;
}
}

HeatMethod::HeatMethod(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , System(std::make_unique<HeatSystem>(mesh))
{
}

HeatMethod::~HeatMethod() = default;

Status HeatMethod::Analyze(const HeatOptions& options, const ProgressCallback& progress)
{
  return this->System->Analyze(options, progress);
}

std::size_t HeatMethod::GetEstimatedMemory() const
{
  return this->System->GetEstimatedMemory();
}

std::size_t HeatMethod::GetMissingMemory() const
{
  return this->System->GetMissingMemory();
}

Status HeatMethod::Factorize(const ProgressCallback& progress)
{
  return this->System->Factorize(progress);
}

Status HeatMethod::Prepare(const HeatOptions& options, const ProgressCallback& progress)
{
  ProgressCallback first;
  ProgressCallback second;
  if (progress)
  {
    first = [&](double fraction) { return progress(0.4 * fraction); };
    second = [&](double fraction) { return progress(0.4 + 0.6 * fraction); };
  }
  Status status = this->Analyze(options, first);
  return status.IsOk() ? this->Factorize(second) : status;
}

Status HeatMethod::Run(
  const std::vector<GeodesicSource>& sources, const HeatQuery& query, HeatResult& result) const
{
  result = HeatResult();
  const HeatSystem& system = *this->System;
  Status status = CheckSources(this->Mesh, sources);
  if (!status.IsOk())
  {
    return status;
  }
  if (std::isnan(query.MaximumDistance))
  {
    return Status::Invalid("the maximum distance is not a number");
  }
  if (!system.IsReady())
  {
    return Status::Invalid("the systems have not been factorized: call Prepare() first");
  }
  const std::vector<Corner> corners = FindCorners(this->Mesh, sources);
  if (system.GetOptions().Boundary == HeatBoundary::Dirichlet)
  {
    std::vector<bool> isHeated(sources.size(), false);
    for (const Corner& corner : corners)
    {
      isHeated[corner.Source] =
        isHeated[corner.Source] || (corner.Weight > 0.0 && !system.IsOnBoundary(corner.Vertex));
    }
    const auto lost = std::find(isHeated.begin(), isHeated.end(), false);
    if (lost != isHeated.end())
    {
      return Status::Invalid("source " + std::to_string(lost - isHeated.begin()) +
        " lies on the boundary, where a Dirichlet condition takes its heat away: use Neumann or "
        "Average");
    }
  }

  std::vector<double> leastOffsets(system.GetNumberOfComponents(), Infinity);
  for (const Corner& corner : corners)
  {
    double& least = leastOffsets[system.GetComponent(corner.Vertex)];
    least = std::min(least, sources[corner.Source].InitialDistance);
  }
  const auto solveProgress = [&](double fraction) {
    return !query.Progress || query.Progress(0.8 * fraction);
  };
  std::vector<double>& distances = result.Distances;
  distances = system.Solve(FindLoads(system, sources, corners, leastOffsets), solveProgress);
  if (distances.empty())
  {
    return Status::Abort();
  }
  const std::vector<double> shifts = FindShifts(system, sources, corners, leastOffsets, distances);
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    const Id component = system.GetComponent(static_cast<Id>(v));
    distances[v] = shifts[component] < Infinity
      ? std::max(distances[v] + shifts[component], leastOffsets[component])
      : Infinity;
  }
  for (const Corner& corner : corners)
  {
    distances[corner.Vertex] =
      std::min(distances[corner.Vertex], sources[corner.Source].InitialDistance + corner.Distance);
  }

  if (query.WantNearestSource || query.WantVirtualSource)
  {
    std::vector<DescentSeed> seeds;
    seeds.reserve(corners.size());
    for (const Corner& corner : corners)
    {
      seeds.push_back(
        { corner.Vertex, corner.Source, sources[corner.Source].InitialDistance + corner.Distance });
    }
    result.NearestSource = FindNearestByDescent(this->Mesh, distances, seeds);
  }
  if (query.Progress && !query.Progress(0.9))
  {
    result = HeatResult();
    return Status::Abort();
  }
  if (query.WantVirtualSource)
  {
    result.Virtual.Offsets.assign(distances.size(), Infinity);
    for (std::size_t v = 0; v < distances.size(); ++v)
    {
      if (result.NearestSource[v] != NoId)
      {
        result.Virtual.Offsets[v] =
          std::min(sources[result.NearestSource[v]].InitialDistance, distances[v]);
      }
    }
    result.Virtual.Angles = FindDirectionsOfDescent(this->Mesh, distances, result.Virtual.Offsets);
    result.Virtual.Lengths.assign(distances.size(), Infinity);
    for (std::size_t v = 0; v < distances.size(); ++v)
    {
      if (distances[v] < Infinity)
      {
        result.Virtual.Lengths[v] = distances[v] - result.Virtual.Offsets[v];
      }
    }
  }
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    if (distances[v] > query.MaximumDistance)
    {
      distances[v] = Infinity;
      for (std::vector<double>* values : { &result.Virtual.Offsets, &result.Virtual.Lengths })
      {
        if (!values->empty())
        {
          (*values)[v] = Infinity;
        }
      }
      if (!result.NearestSource.empty())
      {
        result.NearestSource[v] = NoId;
      }
    }
  }
  if (!query.WantNearestSource)
  {
    result.NearestSource.clear();
  }
  return Status::Success();
}

int HeatMethod::GetNumberOfFactorizations() const
{
  return this->System->GetNumberOfFactorizations();
}

std::size_t HeatMethod::GetMemorySize() const
{
  return this->System->GetMemorySize();
}
}
