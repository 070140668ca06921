// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPathSearch.h"

#include "dggBandPath.h"
#include "dggBlockLoop.h"
#include "dggCounted.h"
#include "dggExactPath.h"
#include "dggGraphSeeds.h"
#include "dggGraphSession.h"
#include "dggOutput.h"
#include "dggPoint3.h"
#include "dggPreparedSurface.h"
#include "dggStatus.h"
#include "dggSurfaceOutput.h"
#include "dggSurfacePath.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace dgg
{
namespace
{
/// Largest accepted ratio of the lengths of a smooth path and the path in the graph.
constexpr double LargestDetour = 1.01;

bool NeedsLinks(const PointPair& pair)
{
  return !IsVertex(pair.From) || !IsVertex(pair.To);
}

/// An arbitrary total order of surface points.
struct PlaceOrder
{
  bool operator()(const SurfacePoint& a, const SurfacePoint& b) const
  {
    return std::tie(a.On, a.Vertex, a.HalfEdge, a.Face, a.Barycentric) <
      std::tie(b.On, b.Vertex, b.HalfEdge, b.Face, b.Barycentric);
  }
};

/// Returns groups of pairs that start at the same point, ordered by their first pair.
std::vector<std::vector<std::size_t>> GroupByStart(const PathSearch::Pairs& pairs)
{
  std::vector<std::vector<std::size_t>> groups;
  std::map<SurfacePoint, std::size_t, PlaceOrder> known;
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

/// Returns the length of a polyline on a cloud.
double MeasurePolyline(const SurfacePath& path, const PreparedSurface& cloud)
{
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.Points.size(); ++i)
  {
    const auto p = PositionOf(cloud.GetMesh(), path.Points[i], cloud.GetPositions());
    const auto q = PositionOf(cloud.GetMesh(), path.Points[i + 1], cloud.GetPositions());
    length += std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  }
  return length;
}

Point3 GetPosition(const SurfacePoint& place, const PreparedSurface& cloud)
{
  const auto p = PositionOf(cloud.GetMesh(), place, cloud.GetPositions());
  return { p[0], p[1], p[2] };
}

/// Returns the points of a path through vertices.
std::vector<SurfacePoint> MakePlaces(const PointPair& pair, const std::vector<Id>& vertices)
{
  std::vector<SurfacePoint> places;
  if (!IsVertex(pair.From))
  {
    places.push_back(pair.From);
  }
  for (const Id vertex : vertices)
  {
    places.push_back(SurfacePoint::AtVertex(vertex));
  }
  if (!IsVertex(pair.To))
  {
    places.push_back(pair.To);
  }
  return places;
}

/// Returns the points of a smooth path. Points beside vertices are stored as offsets from `from`.
std::vector<SurfacePoint> MakePlaces(const BandPath& path, Id from, const PreparedSurface& cloud)
{
  const Point3 origin = GetPosition(SurfacePoint::AtVertex(from), cloud);
  std::vector<SurfacePoint> places;
  for (std::size_t i = 0; i < path.Points.size(); ++i)
  {
    const Point3 offset = path.Points[i] - origin;
    places.push_back(path.Vertices[i] != NoId
        ? SurfacePoint::AtVertex(path.Vertices[i])
        : SurfacePoint::NearVertex(from, { { offset.X, offset.Y, offset.Z } }));
  }
  return places;
}
}

PathSearch::PathSearch(const TaskContext& context, const Pairs& pairs)
  : Context(context)
  , PointPairs(pairs)
{
}

Status PathSearch::RunInGraph(GraphSession& graph, PathOptions options, Paths& paths) const
{
  options.LinkAccuracy = graph.GetLinkAccuracy();
  const bool withLinks = std::any_of(this->PointPairs.begin(), this->PointPairs.end(), NeedsLinks);
  DGG_RETURN_IF_ERROR(graph.PrepareBuilder(this->Context, withLinks));
  DGG_RETURN_IF_ERROR(graph.PrepareForPairs(this->Context, this->PointPairs.size()));
  const PathFinder& finder = graph.GetPathFinder();
  paths.assign(this->PointPairs.size(), FoundPath());
  const auto find = [&](std::size_t i, const ProgressCallback&) {
    return finder.Find(this->PointPairs[i].From, this->PointPairs[i].To, options, paths[i])
      .Of(JoinText("Pair ", i));
  };
  return ForEach(
    paths.size(), 1, this->Context.Parallel, graph.GetRemainingProgress(this->Context), find);
}

Status PathSearch::RunOnCloud(GraphSession& graph, bool smooth, Paths& paths) const
{
  DGG_RETURN_IF_ERROR(graph.PrepareForPairs(this->Context, this->PointPairs.size()));
  paths.assign(this->PointPairs.size(), FoundPath());
  const auto find = [&](std::size_t i, const ProgressCallback& within) {
    return this->FindOnCloud(graph, this->PointPairs[i], smooth, within, paths[i])
      .Of(JoinText("Pair ", i));
  };
  return ForEach(
    paths.size(), 1, this->Context.Parallel, graph.GetRemainingProgress(this->Context), find);
}

Status PathSearch::FindOnCloud(const GraphSession& graph, const PointPair& pair, bool smooth,
  const ProgressCallback& progress, FoundPath& found) const
{
  if (!IsFinite(GetPosition(pair.From, this->Context.Surface)))
  {
    return Status::Success(); // a point without a position has no path, not even to itself
  }
  if (IsSamePoint(pair.From, pair.To))
  {
    found.Path.Points = { pair.From };
    found.GraphLength = 0.0;
    found.IsStraightened = smooth;
    return Status::Success();
  }
  std::vector<GraphLink> from;
  std::vector<GraphLink> to;
  std::vector<double> direct;
  std::vector<double> none;
  DGG_RETURN_IF_ERROR(graph.Link(pair.From, { pair.To }, from, direct));
  DGG_RETURN_IF_ERROR(graph.Link(pair.To, {}, to, none));
  GraphPath path;
  DGG_RETURN_IF_ERROR(graph.GetSearch().Between(MakeSeeds(from), MakeSeeds(to), nullptr, path));
  found.GraphLength = std::min(path.Length, direct[0]);
  if (!(found.GraphLength < Infinity))
  {
    return Status::Success();
  }
  if (path.Length > direct[0])
  {
    path.Vertices.clear(); // the straight path
  }
  found.Path.Points = MakePlaces(pair, path.Vertices);
  found.Path.Length = MeasurePolyline(found.Path, this->Context.Surface);
  found.IsStraightened = smooth;
  if (smooth && !path.Vertices.empty())
  {
    const Point3 start = GetPosition(pair.From, this->Context.Surface);
    const Point3 end = GetPosition(pair.To, this->Context.Surface);
    BandPath band;
    DGG_RETURN_IF_ERROR(graph.MakeShortener().Shorten(path.Vertices,
      IsVertex(pair.From) ? nullptr : &start, IsVertex(pair.To) ? nullptr : &end, band, progress));
    // A smooth path follows the surface, so that it may be longer than the polyline through the
    // vertices. If it is longer than the path in the graph as well, it is rejected.
    const bool isUseful =
      band.Length <= LargestDetour * found.GraphLength || band.Length <= found.Path.Length;
    if (isUseful)
    {
      found.Path.Points = MakePlaces(band, pair.From.Vertex, this->Context.Surface);
      found.Path.Length = MeasurePolyline(found.Path, this->Context.Surface);
    }
    found.IsStraightened = isUseful;
  }
  return Status::Success();
}

Status PathSearch::RunExact(Paths& paths) const
{
  const SurfaceMesh& mesh = this->Context.Surface.GetMesh();
  const std::vector<std::vector<std::size_t>> groups = GroupByStart(this->PointPairs);
  paths.assign(this->PointPairs.size(), FoundPath());
  WorkspacePool<ExactPathFinder> finders;
  const auto step = [&](std::size_t g, const ProgressCallback& within) {
    const std::vector<std::size_t>& group = groups[g];
    std::vector<SurfacePoint> targets;
    for (const std::size_t i : group)
    {
      targets.push_back(this->PointPairs[i].To);
    }
    std::vector<SurfacePath> found;
    const Status status =
      finders.Borrow(mesh)->Find(this->PointPairs[group[0]].From, targets, within, found);
    for (std::size_t k = 0; k < group.size() && status.IsOk(); ++k)
    {
      FoundPath& path = paths[group[k]];
      path.Path = std::move(found[k]);
      path.GraphLength = std::numeric_limits<double>::quiet_NaN();
      path.IsStraightened = !path.Path.IsEmpty();
    }
    const bool isInvalid = !status.IsOk() && !status.IsAborted();
    return isInvalid
      ? status.Of(JoinText("Pair ", group[0], " has no exact path")).Fix("Set {Method} to Graph")
      : status;
  };
  return ForEach(groups.size(), 1, this->Context.Parallel, this->Context.Progress, step);
}

//------------------------------------------------------------------------------
Status ReadPathEnds(const CellArrays& lines, Offset numberOfPoints, std::vector<Offset>& ends)
{
  DGG_RETURN_IF_ERROR(lines.CheckOffsets("{Pairs}"));
  for (Offset i = 0; i < lines.NumberOfCells; ++i)
  {
    const Offset begin = lines.Offsets[i];
    const Offset end = lines.Offsets[i + 1];
    if (begin == end)
    {
      return InvalidInput("Line ", i, " of {Pairs} has no points").Fix("Remove the line");
    }
    for (const Offset id : { lines.Ids[begin], lines.Ids[end - 1] })
    {
      if (id < 0 || id >= numberOfPoints)
      {
        return InvalidInput("Line ", i, " of {Pairs} refers to point ", id, ", but there are ",
          Counted(numberOfPoints, "point"))
          .Fix("Repair the line");
      }
      ends.push_back(id);
    }
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
PathSearch::Pairs MakePairs(const std::vector<SurfacePoint>& ends)
{
  PathSearch::Pairs pairs;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
  {
    pairs.push_back({ ends[i], ends[i + 1] });
  }
  return pairs;
}

//------------------------------------------------------------------------------
Offset CountFallbacks(const PathSearch::Paths& paths)
{
  Offset count = 0;
  for (const FoundPath& path : paths)
  {
    count += path.NumberOfFallbacks;
  }
  return count;
}

//------------------------------------------------------------------------------
std::vector<Offset> WritePaths(
  const TaskContext& context, const PathSearch::Paths& paths, Output& output)
{
  std::int32_t* const status = output.FieldData.Add<std::int32_t>("PathStatus", paths.size());
  std::vector<Offset> pairs; // connected ones
  std::vector<OutputCurve> curves;
  std::size_t firstUnconnected = paths.size();
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    const SurfacePath& path = paths[i].Path;
    status[i] = path.IsEmpty() ? 1 : 0;
    if (path.IsEmpty())
    {
      firstUnconnected = std::min(firstUnconnected, i);
      continue;
    }
    pairs.push_back(static_cast<Offset>(i));
    curves.push_back({ &path });
  }
  WriteCurves(context, curves, output);
  double* const lengths = output.CellData.Add<double>("Length", pairs.size());
  double* const graphLengths = output.CellData.Add<double>("GraphLength", pairs.size());
  std::int32_t* const straightened =
    output.CellData.Add<std::int32_t>("Straightened", pairs.size());
  Offset* const ids = output.CellData.Add<Offset>("PairId", pairs.size());
  for (std::size_t line = 0; line < pairs.size(); ++line)
  {
    const FoundPath& path = paths[pairs[line]];
    lengths[line] = path.Path.Length;
    graphLengths[line] = path.GraphLength;
    straightened[line] = path.IsStraightened ? 1 : 0;
    ids[line] = pairs[line];
  }
  if (firstUnconnected < paths.size())
  {
    output.Warnings.push_back(JoinText("No path ",
      context.Surface.IsCloud() ? "in the graph of the cloud" : "on the surface", " connects ",
      paths.size() - pairs.size(), " of ", paths.size(), " pairs of points (the first is pair ",
      firstUnconnected,
      "). Unconnected pairs have no polyline, and the value 1 in the field array PathStatus"));
  }
  return pairs;
}
}
