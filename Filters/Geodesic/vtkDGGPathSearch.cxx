// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPathSearch.h"

#include "vtkDGGGraphProvider.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGParallel.h"

#include "dggExactPath.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <map>
#include <string>
#include <thread>
#include <tuple>
#include <utility>

namespace
{
/// Paths between two looks at the progress.
constexpr std::size_t PathBlock = 32;
/// Propagations between two looks at the progress from outside of them.
constexpr std::size_t PropagationBlock = 16;

bool IsVertex(const dgg::SurfacePoint& point)
{
  return point.On == dgg::SurfacePoint::Support::Vertex;
}

bool NeedsLinks(const vtkDGGPointPair& pair)
{
  return !IsVertex(pair.From) || !IsVertex(pair.To);
}

/// Any order of places in which equal ones are neighbours.
struct PlaceOrder
{
  bool operator()(const dgg::SurfacePoint& a, const dgg::SurfacePoint& b) const
  {
    return std::tie(a.On, a.Vertex, a.HalfEdge, a.Face, a.Barycentric) <
      std::tie(b.On, b.Vertex, b.HalfEdge, b.Face, b.Barycentric);
  }
};

/// Indices of the pairs that start at the same point, by their first one.
std::vector<std::vector<std::size_t>> GroupByStart(const vtkDGGPathSearch::Pairs& pairs)
{
  std::vector<std::vector<std::size_t>> groups;
  std::map<dgg::SurfacePoint, std::size_t, PlaceOrder> known;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const auto entry = known.emplace(pairs[i].From, groups.size());
    if (entry.second)
    {
      groups.emplace_back();
    }
    groups[entry.first->second].push_back(i);
  }
  return groups;
}

/// Progress of steps that take long and run in several threads: only the thread that waits for them
/// may tell it; the others learn whether to go on.
class SharedProgress
{
public:
  SharedProgress(const dgg::ProgressCallback& progress, std::size_t count)
    : Progress(progress)
    , Count(static_cast<double>(count))
    , Teller(std::this_thread::get_id())
  {
  }

  /// That of one step. Steps run in any order, so that it counts as if there were no other.
  dgg::ProgressCallback OfStep()
  {
    return [this](double fraction) {
      if (std::this_thread::get_id() == this->Teller && !this->IsStopped)
      {
        this->IsStopped = !this->Progress(this->Done + (1.0 - this->Done) * fraction / this->Count);
      }
      return !this->IsStopped;
    };
  }

  /// That of the steps done, between them.
  bool Tell(double done)
  {
    this->Done = done;
    return !this->IsStopped && this->Progress(done);
  }

private:
  const dgg::ProgressCallback& Progress;
  double Count;
  std::thread::id Teller;
  double Done = 0.0; // changes only while no step runs
  std::atomic<bool> IsStopped{ false };
};

/// An error with what it is about before it, and what to do after it.
dgg::Status Explain(const dgg::Status& status, const std::string& subject, const char* remedy)
{
  return status.IsOk() || status.IsAborted()
    ? status
    : dgg::Status::Invalid(subject + status.GetMessage() + remedy);
}
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGPathSearch::RunInGraph(
  vtkDGGGraphProvider& graph, const double* positions, dgg::PathOptions options, Paths& paths) const
{
  options.LinkAccuracy = graph.GetLinkAccuracy();
  const bool withLinks = std::any_of(this->PointPairs.begin(), this->PointPairs.end(), NeedsLinks);
  if (withLinks)
  {
    const dgg::Status prepared = graph.PrepareBuilder(this->Mesh);
    if (!prepared.IsOk())
    {
      return prepared;
    }
  }
  else
  {
    graph.ReleaseBuilder();
  }
  const dgg::PathFinder finder(
    this->Mesh.GetMesh(), graph.GetSearch(), withLinks ? &graph.GetBuilder() : nullptr, positions);
  paths.assign(this->PointPairs.size(), dgg::FoundPath());
  const dgg::Status status =
    vtkDGGForBlocks(paths.size(), PathBlock, graph.GetRemainingProgress(), [&](std::size_t i) {
      return Explain(
        finder.Find(this->PointPairs[i].From, this->PointPairs[i].To, options, paths[i]),
        "pair " + std::to_string(i) + ": ", "");
    });
  const dgg::Status intact = graph.CheckArrays();
  return intact.IsOk() ? status : intact;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGPathSearch::RunExact(const dgg::ProgressCallback& progress, Paths& paths) const
{
  const dgg::SurfaceMesh& mesh = this->Mesh.GetMesh();
  const std::vector<std::vector<std::size_t>> groups = GroupByStart(this->PointPairs);
  paths.assign(this->PointPairs.size(), dgg::FoundPath());
  dgg::WorkspacePool<dgg::ExactPathFinder> finders;
  SharedProgress shared(progress, groups.size());
  const auto step = [&](std::size_t g) {
    const std::vector<std::size_t>& group = groups[g];
    std::vector<dgg::SurfacePoint> targets;
    for (const std::size_t i : group)
    {
      targets.push_back(this->PointPairs[i].To);
    }
    std::vector<dgg::SurfacePath> found;
    const dgg::Status status =
      finders.Borrow(mesh)->Find(this->PointPairs[group[0]].From, targets, shared.OfStep(), found);
    for (std::size_t k = 0; k < group.size() && status.IsOk(); ++k)
    {
      dgg::FoundPath& path = paths[group[k]];
      path.Path = std::move(found[k]);
      path.GraphLength = std::numeric_limits<double>::quiet_NaN();
      path.IsStraightened = !path.Path.IsEmpty();
    }
    return Explain(status,
      "of the paths that start where pair " + std::to_string(group[0]) + " does, ",
      ". Use Method Graph");
  };
  return vtkDGGForBlocks(
    groups.size(), PropagationBlock, [&](double done) { return shared.Tell(done); }, step);
}
