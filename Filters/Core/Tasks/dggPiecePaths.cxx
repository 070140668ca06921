// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPiecePaths.h"

#include "dggBlockLoop.h"
#include "dggBoxTree.h"
#include "dggPieceSearch.h"
#include "dggPieceSurface.h"
#include "dggProcessGroup.h"
#include "dggProgressPart.h"
#include "dggSourceCollection.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace dgg
{
namespace
{
/// Progress weight of searches.
constexpr double SearchShare = 0.7;
/// Distance from a path within which cells are gathered first: fraction of the length of the path,
/// which straightening may need, plus a number of mean edges, so that the path is inside. Both are
/// multiplied by a factor as long as the path meets the rim of these cells.
constexpr double WidthOfPath = 0.01;
constexpr double WidthInEdges = 2.0;
constexpr double WidthFactor = 4.0;
constexpr int MostAttempts = 3;

using Point = std::array<double, 3>;

double MeasureDistance(const double* p, const double* q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// Points within a distance of a graph edge. All paths along the edge are inside the ellipsoid
/// whose foci are the ends of the edge.
struct Ellipsoid
{
  const double* Foci[2];
  double Sum; // of the distances from both foci

  bool Contains(const double* p) const
  {
    return MeasureDistance(p, this->Foci[0]) + MeasureDistance(p, this->Foci[1]) <= this->Sum;
  }
  Box GetBox() const
  {
    const double foci = MeasureDistance(this->Foci[0], this->Foci[1]);
    const double minor = 0.5 * std::sqrt(std::max(0.0, this->Sum * this->Sum - foci * foci));
    Box box;
    for (const double sign : { -1.0, 1.0 })
    {
      Point corner;
      for (int k = 0; k < 3; ++k)
      {
        const double center = 0.5 * (this->Foci[0][k] + this->Foci[1][k]);
        corner[k] = center + sign * std::hypot(minor, this->Foci[0][k] - center);
      }
      box.Add(corner.data());
    }
    return box;
  }
};

/// The surroundings of routes.
class Surroundings
{
public:
  Surroundings(const std::vector<PieceRoute>& routes, const std::vector<double>& widths)
  {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < routes.size(); ++i)
    {
      const std::vector<PieceStep>& steps = routes[i].Steps;
      for (std::size_t k = 0; k < steps.size(); ++k)
      {
        // The start of the path has no edge, so that its ellipsoid is a ball.
        const PieceStep& tail = steps[std::min(k + 1, steps.size() - 1)];
        this->Ellipsoids.push_back(
          { { steps[k].Position, tail.Position }, steps[k].Length + 2.0 * widths[i] });
        boxes.push_back(this->Ellipsoids.back().GetBox());
      }
    }
    this->Tree = BoxTree(boxes);
  }

  bool Contain(const double* point) const
  {
    const Point p{ { point[0], point[1], point[2] } };
    bool isInside = false;
    this->Tree.ForEach(
      [&](const Box& box) { return !isInside && box.GetSquaredDistance(p) == 0.0; },
      [&](Id i) { isInside = isInside || this->Ellipsoids[i].Contains(point); });
    return isInside;
  }

private:
  std::vector<Ellipsoid> Ellipsoids;
  BoxTree Tree;
};

/// Finds the routes of all pairs, one search per start.
Status FindRoutes(const TaskContext& context, ProcessGroup& group, const SurfacePiece& piece,
  PieceSearch& search, const std::vector<Offset>& ends, std::vector<PieceRoute>& routes,
  bool& isUsable)
{
  std::map<Offset, std::vector<std::size_t>> pairsOfStarts;
  for (std::size_t i = 0; i < routes.size(); ++i)
  {
    pairsOfStarts[ends[2 * i]].push_back(i);
  }
  double done = 0.0;
  for (const auto& [start, pairs] : pairsOfStarts)
  {
    PieceSearchOptions options;
    const double next = done + SearchShare / static_cast<double>(pairsOfStarts.size());
    options.Progress = ProgressPart(context.Progress, done, next);
    done = next;
    PieceDistances distances;
    DGG_RETURN_IF_ERROR(
      search.Run(group, { { start, GraphSeed() } }, options, distances, isUsable));
    std::vector<Offset> targets;
    for (const std::size_t pair : pairs)
    {
      targets.push_back(ends[2 * pair + 1]);
    }
    std::vector<PieceRoute> found;
    if (isUsable)
    {
      DGG_RETURN_IF_ERROR(search.FollowBack(group, piece, targets, found, isUsable));
    }
    if (!isUsable)
    {
      return Status::Success();
    }
    for (std::size_t k = 0; k < pairs.size(); ++k)
    {
      routes[pairs[k]] = std::move(found[k]);
    }
  }
  return Status::Success();
}

/// Traces a route on the surface that was gathered. Returns false if this is not possible.
bool Trace(const PieceSurface& surface, const PathFinder& finder, const PieceRoute& found,
  const PathOptions& options, FoundPath& path)
{
  path = FoundPath();
  if (found.Steps.empty())
  {
    return true;
  }
  GraphRoute route;
  route.Length = found.Length;
  for (auto step = found.Steps.rbegin(); step != found.Steps.rend(); ++step)
  {
    route.Vertices.push_back(surface.FindVertex(step->PointId));
    if (step != found.Steps.rbegin())
    {
      route.Angles.push_back(step->Angle);
      route.Lengths.push_back(step->Length);
    }
  }
  return finder
           .Trace(SurfacePoint::AtVertex(route.Vertices.front()),
             SurfacePoint::AtVertex(route.Vertices.back()), route, options, path)
           .IsOk() &&
    !path.MeetsRim && path.NumberOfFallbacks == 0;
}
}

Status FindPiecePaths(const TaskContext& context, ProcessGroup& group, const SurfacePiece& piece,
  PieceSearch& search, PieceSurface& surface, const SourceCollection& ends,
  const PathOptions& options, PathSearch::Paths& paths, bool& isDone)
{
  DGG_RETURN_IF_ERROR(ends.Check(search.GetNumberOfPoints()));
  std::vector<Offset> ids;
  std::vector<PieceSeed> seeds;
  for (const Offset id : ends.Ids)
  {
    ids.push_back(search.GetFirstId() + id);
    seeds.push_back({ ids.back(), GraphSeed() });
  }
  std::vector<std::size_t> isolated;
  DGG_RETURN_IF_ERROR(search.FindIsolated(group, seeds, isolated));
  std::vector<PieceRoute> routes(ids.size() / 2);
  isDone = isolated.empty();
  if (isDone)
  {
    DGG_RETURN_IF_ERROR(FindRoutes(context, group, piece, search, ids, routes, isDone));
  }
  if (!isDone)
  {
    return Status::Success();
  }
  std::vector<double> widths;
  for (const PieceRoute& route : routes)
  {
    const double share = options.Straighten
      ? WidthOfPath + 0.5 * std::sqrt(options.Detour * (2.0 + options.Detour))
      : 0.0;
    widths.push_back((route.Length < Infinity ? share * route.Length : 0.0) +
      WidthInEdges * surface.GetMeanEdgeLength());
  }
  const ProgressCallback progress = ProgressPart(context.Progress, SearchShare, 1.0);
  for (int attempt = 0; attempt < MostAttempts; ++attempt)
  {
    const Surroundings near(routes, widths);
    DGG_RETURN_IF_ERROR(surface.GatherNear(
      group, [&](const double* p) { return near.Contain(p); }, search.GetMemorySize()));
    std::vector<std::uint8_t> isTraced(routes.size(), 1);
    Status status;
    if (group.Here == 0)
    {
      paths.resize(routes.size());
      const PathFinder finder(surface.Get().GetMesh(), surface.GetRim().data());
      status = ForEach(
        routes.size(), 1, context.Parallel, progress, [&](std::size_t i, const ProgressCallback&) {
          isTraced[i] = Trace(surface, finder, routes[i], options, paths[i]) ? 1 : 0;
          return Status::Success();
        });
    }
    DGG_RETURN_IF_ERROR(group.Agree(status));
    DGG_RETURN_IF_ERROR(group.TakeListFromFirst(isTraced));
    isDone = std::find(isTraced.begin(), isTraced.end(), 0) == isTraced.end();
    if (isDone)
    {
      break;
    }
    for (std::size_t i = 0; i < widths.size(); ++i)
    {
      widths[i] *= isTraced[i] ? 1.0 : WidthFactor;
    }
  }
  return Status::Success();
}
}
