// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPathSearch.h"

#include "DGGGraphUser.h"
#include "DGGProperties.h"
#include "DGGThreads.h"

#include "dggBandPath.h"
#include "dggExactPath.h"
#include "dggPoint3.h"
#include "dggSurfacePath.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace
{
/// Length of a smooth path by that in the graph, at most.
constexpr double LargestDetour = 1.01;

bool NeedsLinks(const DGGPointPair& pair)
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
std::vector<std::vector<std::size_t>> GroupByStart(const DGGPathSearch::Pairs& pairs)
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

/// The links of a place as seeds of a search.
std::vector<dgg::GraphSeed> MakeSeeds(const std::vector<dgg::GraphLink>& links)
{
  std::vector<dgg::GraphSeed> seeds;
  for (const dgg::GraphLink& link : links)
  {
    seeds.push_back({ link.Vertex, link.Length, 0.0, 0, link.ArrivalAngle });
  }
  return seeds;
}

/// Length of a polyline through points of a cloud, or near them.
double MeasurePolyline(const dgg::SurfacePath& path, const dgg::PreparedSurface& cloud)
{
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.Points.size(); ++i)
  {
    const auto p = dgg::PositionOf(cloud.GetMesh(), path.Points[i], cloud.GetPositions());
    const auto q = dgg::PositionOf(cloud.GetMesh(), path.Points[i + 1], cloud.GetPositions());
    length += std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  }
  return length;
}

dgg::Point3 GetPosition(const dgg::SurfacePoint& place, const dgg::PreparedSurface& cloud)
{
  const auto p = dgg::PositionOf(cloud.GetMesh(), place, cloud.GetPositions());
  return { p[0], p[1], p[2] };
}

/// A path from place to place over points of a cloud.
std::vector<dgg::SurfacePoint> MakePlaces(
  const DGGPointPair& pair, const std::vector<dgg::Id>& vertices)
{
  std::vector<dgg::SurfacePoint> places;
  if (!dgg::IsVertex(pair.From))
  {
    places.push_back(pair.From);
  }
  for (const dgg::Id vertex : vertices)
  {
    places.push_back(dgg::SurfacePoint::AtVertex(vertex));
  }
  if (!dgg::IsVertex(pair.To))
  {
    places.push_back(pair.To);
  }
  return places;
}

/// A smooth path; its points beside those of the cloud as seen from a point of it, no matter which.
std::vector<dgg::SurfacePoint> MakePlaces(
  const dgg::BandPath& path, dgg::Id from, const dgg::PreparedSurface& cloud)
{
  const dgg::Point3 origin = GetPosition(dgg::SurfacePoint::AtVertex(from), cloud);
  std::vector<dgg::SurfacePoint> places;
  for (std::size_t i = 0; i < path.Points.size(); ++i)
  {
    const dgg::Point3 offset = path.Points[i] - origin;
    places.push_back(path.Vertices[i] != dgg::NoId
        ? dgg::SurfacePoint::AtVertex(path.Vertices[i])
        : dgg::SurfacePoint::NearVertex(from, { { offset.X, offset.Y, offset.Z } }));
  }
  return places;
}

}

//------------------------------------------------------------------------------
DGGPathSearch::DGGPathSearch(const DGGContext& context, const Pairs& pairs)
  : Context(context)
  , Mesh(context.Surface)
  , PointPairs(pairs)
{
}

//------------------------------------------------------------------------------
dgg::Status DGGPathSearch::RunInGraph(
  DGGGraphUser& graph, dgg::PathOptions options, Paths& paths) const
{
  options.LinkAccuracy = graph.GetLinkAccuracy();
  const bool withLinks = std::any_of(this->PointPairs.begin(), this->PointPairs.end(), NeedsLinks);
  DGG_RETURN_IF_ERROR(graph.PrepareBuilder(this->Context, withLinks));
  DGG_RETURN_IF_ERROR(graph.PrepareForPairs(this->Context, this->PointPairs.size()));
  const dgg::PathFinder& finder = graph.GetPathFinder();
  paths.assign(this->PointPairs.size(), dgg::FoundPath());
  const auto find = [&](std::size_t i, const dgg::ProgressCallback&) {
    return finder.Find(this->PointPairs[i].From, this->PointPairs[i].To, options, paths[i])
      .Of("pair " + std::to_string(i));
  };
  return DGGForEach(paths.size(), 1, graph.GetRemainingProgress(this->Context), find);
}

//------------------------------------------------------------------------------
dgg::Status DGGPathSearch::RunOnCloud(DGGGraphUser& graph, bool smooth, Paths& paths) const
{
  DGG_RETURN_IF_ERROR(graph.PrepareForPairs(this->Context, this->PointPairs.size()));
  paths.assign(this->PointPairs.size(), dgg::FoundPath());
  const auto find = [&](std::size_t i, const dgg::ProgressCallback& within) {
    return this->FindOnCloud(graph, this->PointPairs[i], smooth, within, paths[i])
      .Of("pair " + std::to_string(i));
  };
  return DGGForEach(paths.size(), 1, graph.GetRemainingProgress(this->Context), find);
}

//------------------------------------------------------------------------------
dgg::Status DGGPathSearch::FindOnCloud(const DGGGraphUser& graph, const DGGPointPair& pair,
  bool smooth, const dgg::ProgressCallback& progress, dgg::FoundPath& found) const
{
  if (!dgg::IsFinite(GetPosition(pair.From, this->Mesh)))
  {
    return dgg::Status::Success(); // it is nowhere, so not even at itself
  }
  if (dgg::IsSamePoint(pair.From, pair.To))
  {
    found.Path.Points = { pair.From };
    found.GraphLength = 0.0;
    found.IsStraightened = smooth;
    return dgg::Status::Success();
  }
  std::vector<dgg::GraphLink> from;
  std::vector<dgg::GraphLink> to;
  std::vector<double> direct;
  std::vector<double> none;
  DGG_RETURN_IF_ERROR(graph.Link(pair.From, { pair.To }, from, direct));
  DGG_RETURN_IF_ERROR(graph.Link(pair.To, {}, to, none));
  dgg::GraphPath path;
  DGG_RETURN_IF_ERROR(graph.GetSearch().Between(MakeSeeds(from), MakeSeeds(to), nullptr, path));
  found.GraphLength = std::min(path.Length, direct[0]);
  if (!(found.GraphLength < dgg::Infinity))
  {
    return dgg::Status::Success();
  }
  if (path.Length > direct[0])
  {
    path.Vertices.clear(); // the straight way
  }
  found.Path.Points = MakePlaces(pair, path.Vertices);
  found.Path.Length = MeasurePolyline(found.Path, this->Mesh);
  found.IsStraightened = smooth;
  if (smooth && !path.Vertices.empty())
  {
    const dgg::Point3 start = GetPosition(pair.From, this->Mesh);
    const dgg::Point3 end = GetPosition(pair.To, this->Mesh);
    dgg::BandPath band;
    DGG_RETURN_IF_ERROR(graph.MakeShortener(this->Mesh)
                          .Shorten(path.Vertices, dgg::IsVertex(pair.From) ? nullptr : &start,
                            dgg::IsVertex(pair.To) ? nullptr : &end, band, progress));
    // A smooth path follows the surface, so that it is longer than straight lines from point to
    // point; but one that is longer than the way in the graph as well has gone astray.
    const bool isUseful =
      band.Length <= LargestDetour * found.GraphLength || band.Length <= found.Path.Length;
    if (isUseful)
    {
      found.Path.Points = MakePlaces(band, pair.From.Vertex, this->Mesh);
      found.Path.Length = MeasurePolyline(found.Path, this->Mesh);
    }
    found.IsStraightened = isUseful;
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGPathSearch::RunExact(Paths& paths) const
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
    return DGGExplain(status,
      "of the paths that start where pair " + std::to_string(group[0]) + " does, ",
      ". Use Method Graph");
  };
  return DGGForEach(groups.size(), 1, this->Context.Progress, step);
}
