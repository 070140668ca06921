// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSourceGroups.h"

#include <algorithm>
#include <numeric>

namespace dgg
{
namespace
{
/// Breadth-first walks over the surface.
class SurfaceWalk
{
public:
  explicit SurfaceWalk(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , LastWalk(mesh.GetNumberOfVertices(), 0)
  {
  }

  /// Visits the component of a vertex, until `visit(vertex)` returns false.
  template <typename Visit>
  void Run(Id start, const Visit& visit)
  {
    ++this->Walk;
    this->Queue.clear();
    this->Reach(start);
    // NOLINTNEXTLINE(modernize-loop-convert): the queue grows during the loop
    for (std::size_t next = 0; next < this->Queue.size(); ++next)
    {
      const Id v = this->Queue[next];
      if (!visit(v))
      {
        return;
      }
      for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
      {
        this->Reach(this->Mesh.Destination(*g));
        this->Reach(this->Mesh.Apex(*g));
      }
    }
  }

private:
  void Reach(Id v)
  {
    if (this->LastWalk[v] != this->Walk)
    {
      this->LastWalk[v] = this->Walk;
      this->Queue.push_back(v);
    }
  }

  const SurfaceMesh& Mesh;
  std::vector<Id> Queue;
  std::vector<Offset> LastWalk; ///< per vertex, index of the last walk that visited it
  Offset Walk = 0;
};

/// Returns, per vertex, its rank in a walk from the first vertex of its component.
std::vector<Id> ComputeRemoteness(const SurfaceMesh& mesh)
{
  constexpr Id unknown = -1;
  std::vector<Id> remoteness(mesh.GetNumberOfVertices(), unknown);
  SurfaceWalk walk(mesh);
  for (Id root = 0; root < mesh.GetNumberOfVertices(); ++root)
  {
    if (remoteness[root] == unknown)
    {
      Id count = 0;
      walk.Run(root, [&](Id v) {
        remoteness[v] = count++;
        return true;
      });
    }
  }
  return remoteness;
}
}

std::vector<SourceGroup> GroupSources(
  const SurfaceMesh& mesh, const std::vector<Id>& sources, std::size_t groupSize)
{
  const std::vector<Id> remoteness = ComputeRemoteness(mesh);
  std::vector<std::size_t> order(sources.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return remoteness[sources[a]] > remoteness[sources[b]]; });
  // Ungrouped sources per vertex; a vertex may have several.
  std::vector<SourceGroup> waiting(mesh.GetNumberOfVertices());
  for (std::size_t place : order)
  {
    waiting[sources[place]].push_back(place);
  }
  std::vector<SourceGroup> groups;
  SurfaceWalk walk(mesh);
  for (std::size_t place : order)
  {
    while (!waiting[sources[place]].empty())
    {
      SourceGroup group;
      walk.Run(sources[place], [&](Id v) {
        while (!waiting[v].empty() && group.size() < groupSize)
        {
          group.push_back(waiting[v].back());
          waiting[v].pop_back();
        }
        return group.size() < groupSize;
      });
      groups.push_back(std::move(group));
    }
  }
  return groups;
}
}
