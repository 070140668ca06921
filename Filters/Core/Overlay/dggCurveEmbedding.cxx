// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCurveEmbedding.h"

#include "dggEdgeSplitting.h"
#include "dggStatus.h"
#include "dggSurfaceRefinement.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
/// Returns the parameter of a curve at a position along its path.
double ParameterAt(const SurfaceCurve& curve, double place)
{
  const auto piece = static_cast<std::size_t>(place);
  if (piece + 1 >= curve.Parameters.size())
  {
    return curve.Parameters.back();
  }
  const double from = curve.Parameters[piece];
  return from + (curve.Parameters[piece + 1] - from) * (place - std::floor(place));
}

/// Returns the edge, smaller vertex first, of a path with a single edge; otherwise no edge.
std::pair<Id, Id> FindOnlyEdge(const std::vector<Id>& path)
{
  const std::pair<Id, Id> none(NoId, NoId);
  std::pair<Id, Id> only = none;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const std::pair<Id, Id> edge = std::minmax(path[i], path[i + 1]);
    if (i > 0 && edge != only)
    {
      return none;
    }
    only = edge;
  }
  return only;
}

/// Splits edges that form an entire path, because a cut along a single edge would not open the
/// surface. Continuations by other paths do not count, since callers need not cut along all paths.
void SplitLoneEdges(const SurfaceMesh& mesh, SubMesh& surface)
{
  std::vector<std::pair<Id, Id>> edges;
  for (const std::vector<Id>& path : surface.Paths)
  {
    const std::pair<Id, Id> edge = FindOnlyEdge(path);
    if (edge.first != NoId)
    {
      edges.push_back(edge);
    }
  }
  if (edges.empty())
  {
    return;
  }
  std::sort(edges.begin(), edges.end());
  const auto halfEdges = static_cast<Id>(surface.Triangles.size());
  const auto destination = [&](Id h) { return surface.Triangles[SurfaceMesh::Next(h)]; };
  std::vector<char> isOnBoundary(surface.Points.size(), 0);
  for (Id h = 0; h < halfEdges; ++h)
  {
    if (surface.Twins[h] == NoId)
    {
      isOnBoundary[surface.Triangles[h]] = 1; // here one edge suffices to open the surface
      isOnBoundary[destination(h)] = 1;
    }
  }
  std::vector<char> isSplit(halfEdges, 0);
  bool isAny = false;
  for (Id h = 0; h < halfEdges; ++h)
  {
    const std::pair<Id, Id> ends = std::minmax(surface.Triangles[h], destination(h));
    if (!isOnBoundary[ends.first] && !isOnBoundary[ends.second] &&
      std::binary_search(edges.begin(), edges.end(), ends) && HasMiddle(mesh, surface, h))
    {
      isSplit[h] = 1;
      isAny = true;
    }
  }
  if (isAny)
  {
    SplitEdges(mesh, isSplit, surface);
  }
}
}

Status EmbedCurves(const SurfaceMesh& mesh, const std::vector<SurfaceCurve>& curves,
  const ProgressCallback& progress, SubMesh& surface)
{
  surface = SubMesh();
  std::vector<SurfacePath> paths;
  paths.reserve(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (curves[c].Parameters.size() != curves[c].Path.Points.size())
    {
      return InvalidInput("Curve ", c, " has ", curves[c].Path.Points.size(), " points, but ",
        curves[c].Parameters.size(), " parameters")
        .Fix("Give one parameter per point");
    }
    paths.push_back(curves[c].Path);
  }
  RefinementOptions options;
  options.InsertCrossings = true;
  options.Progress = progress;
  DGG_RETURN_IF_ERROR(RefineAlongPaths(mesh, paths, options, surface));
  SplitLoneEdges(mesh, surface);
  return Status::Success();
}

CurveChain FollowCurve(
  const SubMesh& surface, const std::vector<SurfaceCurve>& curves, std::size_t number)
{
  const SurfaceCurve& curve = curves[number];
  const std::vector<double>& places = surface.Places[number];
  CurveChain chain;
  chain.Vertices = surface.Paths[number];
  chain.Parameters.reserve(places.size());
  for (const double place : places)
  {
    chain.Parameters.push_back(ParameterAt(curve, place));
  }
  for (const Offset point : curve.GivenPoints)
  {
    // Points of the path that were merged into one vertex have the position of the first of them.
    const auto beyond = std::upper_bound(places.begin(), places.end(), static_cast<double>(point));
    chain.GivenPoints.push_back(static_cast<Offset>(beyond - places.begin()) - 1);
  }
  return chain;
}
}
