// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPathSearch.h"

#include "vtkDGGGraphProvider.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGParallel.h"

#include "dggExactPath.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace
{
/// Paths at least between two looks at the progress.
constexpr std::size_t PathBlock = 16;

bool NeedsLinks(const vtkDGGPointPair& pair)
{
  return !dgg::IsVertex(pair.From) || !dgg::IsVertex(pair.To);
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
  const dgg::Status guided = graph.PrepareForPairs(this->PointPairs.size());
  if (!guided.IsOk())
  {
    const dgg::Status intact = graph.CheckArrays();
    return intact.IsOk() ? guided : intact;
  }
  const dgg::PathFinder& finder = graph.GetPathFinder(this->Mesh, positions);
  paths.assign(this->PointPairs.size(), dgg::FoundPath());
  // No look at the progress while threads search: an observer may empty the arrays of the graph.
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
  const auto step = [&](std::size_t g, const dgg::ProgressCallback& within) {
    const std::vector<std::size_t>& group = groups[g];
    std::vector<dgg::SurfacePoint> targets;
    for (const std::size_t i : group)
    {
      targets.push_back(this->PointPairs[i].To);
    }
    std::vector<dgg::SurfacePath> found;
    const dgg::Status status =
      finders.Borrow(mesh)->Find(this->PointPairs[group[0]].From, targets, within, found);
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
  return vtkDGGForLongSteps(groups.size(), progress, step);
}
