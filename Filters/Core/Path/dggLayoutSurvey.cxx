// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLayoutSurvey.h"

#include "dggExactPath.h"
#include "dggSurfaceRefinement.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace dgg
{
namespace
{
/// Place of a neighbour in the fan of a vertex; behind all when it is not there.
double PlaceInFan(const SurfaceMesh& mesh, Id vertex, Id neighbour)
{
  const Id* begin = mesh.FanBegin(vertex);
  const Id* end = mesh.FanEnd(vertex);
  const Id* place = end;
  for (const Id* g = begin; g != end; ++g)
  {
    place = mesh.Destination(*g) == neighbour ? g : place;
  }
  return static_cast<double>(place - begin);
}
}

Status LayoutSurvey::FindPaths(const ProgressCallback& progress, Id& unconnected)
{
  unconnected = NoId;
  const auto count = static_cast<Id>(this->Landmarks.size());
  ExactPathFinder finder(this->Mesh);
  Status status;
  for (Id l = 0; l < count && status.IsOk() && unconnected == NoId; ++l)
  {
    const auto part = [&](double fraction) {
      return !progress || progress((l + fraction) / static_cast<double>(count));
    };
    status = this->FindPathsFrom(finder, l, part, unconnected);
  }
  return status;
}

/// To the other ends of the edges that leave the landmark.
Status LayoutSurvey::FindPathsFrom(
  ExactPathFinder& finder, Id landmark, const ProgressCallback& progress, Id& unconnected)
{
  std::vector<Id> leaving;
  std::vector<SurfacePoint> to;
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    if (this->Edges[e][0] == landmark)
    {
      leaving.push_back(static_cast<Id>(e));
      to.push_back(this->Landmarks[this->Edges[e][1]]);
    }
  }
  if (to.empty())
  {
    return Status::Success();
  }
  std::vector<SurfacePath> found;
  Status status = finder.Find(this->Landmarks[landmark], to, progress, found);
  for (std::size_t i = 0; i < found.size() && unconnected == NoId; ++i)
  {
    unconnected = found[i].IsEmpty() ? leaving[i] : NoId;
    this->Paths[leaving[i]] = std::move(found[i]);
  }
  return status;
}

std::vector<EdgeOrder> LayoutSurvey::FindOrders() const
{
  std::vector<EdgeOrder> orders(this->Landmarks.size());
  RefinedSurface crossed;
  SurfaceMesh mesh;
  RefinementOptions options;
  options.InsertCrossings = true;
  if (!RefineAlongPaths(this->Mesh, this->Paths, options, crossed).IsOk() ||
    !crossed.Build(this->Mesh, mesh).IsOk())
  {
    return orders;
  }
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    for (const int end : { 0, 1 })
    {
      if (crossed.Paths[e].size() >= 2)
      {
        orders[this->Edges[e][end]].Edges.push_back(static_cast<Id>(e));
      }
    }
  }
  for (std::size_t l = 0; l < this->Landmarks.size(); ++l)
  {
    std::map<Id, double> place; // of an edge in the fan
    for (const Id e : orders[l].Edges)
    {
      const std::vector<Id>& chain = crossed.Paths[e];
      const bool leaves = this->Edges[e][0] == static_cast<Id>(l);
      place[e] = PlaceInFan(
        mesh, leaves ? chain.front() : chain.back(), leaves ? chain[1] : chain[chain.size() - 2]);
    }
    std::stable_sort(orders[l].Edges.begin(), orders[l].Edges.end(),
      [&](Id a, Id b) { return place[a] < place[b]; });
  }
  return orders;
}
}
