// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPathFinder.h"

#include "dggGraphSeeds.h"
#include "dggPathCorridor.h"
#include "dggPathShortener.h"
#include "dggPathTracer.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <utility>

namespace dgg
{
/// Workspace for finding one path.
struct PathFinder::Workspace
{
  Workspace(const SurfaceMesh& mesh, const std::uint8_t* isRim)
    : Tracer(mesh)
    , Shortener(mesh, isRim)
    , Corridor(mesh, isRim)
  {
  }

  /// Returns the size in bytes of the buffers that are as large as the mesh.
  std::size_t GetMemorySize() const
  {
    return this->Corridor.GetMemorySize() + this->Tracer.GetMemorySize();
  }

  /// Replaces a path by the shortened path of the chain.
  void Straighten(SurfacePath& path)
  {
    path.Clear();
    for (Strip& strip : this->Tracer.GetStrips())
    {
      this->Shortener.Shorten(strip);
      this->Shortener.Append(strip, path);
    }
  }

  PathTracer Tracer;
  PathShortener Shortener;
  PathCorridor Corridor;
};

/// Links of two points to the graph.
struct PathFinder::Ends
{
  std::vector<GraphLink> Links[2]; ///< links of the first and the last point
  double Direct = Infinity;        ///< length of the straight line between them
};

PathFinder::PathFinder(const SurfaceMesh& mesh, const GraphSearch& search,
  const GraphBuilder* builder, const double* positions)
  : Mesh(mesh)
  , Search(&search)
  , Builder(builder)
  , Positions(positions)
  , Usable(CheckCorners(mesh))
  , Workspaces(std::make_unique<WorkspacePool<Workspace>>())
{
}

PathFinder::PathFinder(const SurfaceMesh& mesh, const std::uint8_t* isRim)
  : Mesh(mesh)
  , IsRim(isRim)
  , Usable(CheckCorners(mesh))
  , Workspaces(std::make_unique<WorkspacePool<Workspace>>())
{
}

PathFinder::~PathFinder() = default;

std::size_t PathFinder::GetMemorySize() const
{
  return this->Workspaces->GetMemorySize();
}

Status PathFinder::Find(const SurfacePoint& from, const SurfacePoint& to,
  const PathOptions& options, FoundPath& found) const
{
  found = FoundPath();
  Status status = this->FindBetween(from, to, options, found);
  if (!status.IsOk())
  {
    found = FoundPath();
  }
  return status;
}

Status PathFinder::FindBetween(const SurfacePoint& from, const SurfacePoint& to,
  const PathOptions& options, FoundPath& found) const
{
  DGG_RETURN_IF_ERROR(this->Usable);
  const GraphView& graph = this->Search->GetGraph();
  if (!graph.Angles)
  {
    return InvalidInput("The graph has no directions, which paths need")
      .Fix("Use the graph of a mesh");
  }
  const double linkAccuracy =
    options.LinkAccuracy > 0.0 ? options.LinkAccuracy : graph.Info.Accuracy;
  Ends ends;
  GraphRoute route;
  DGG_RETURN_IF_ERROR(this->Link(from, to, linkAccuracy, ends));
  if (!IsSamePoint(from, to))
  {
    GraphPath path;
    DGG_RETURN_IF_ERROR(this->Search->Between(
      MakeSeeds(ends.Links[0]), MakeSeeds(ends.Links[1]), this->Positions, path));
    route.Length = path.Length;
    route.Direct = ends.Direct;
    for (const Offset e : path.Edges)
    {
      route.Angles.push_back(graph.Angles[e]);
      route.Lengths.push_back(graph.Length(e));
    }
    if (!path.Vertices.empty())
    {
      route.Links[0] = ends.Links[0][path.FromSeed];
      route.Links[1] = ends.Links[1][path.ToSeed];
    }
    route.Vertices = std::move(path.Vertices);
  }
  return this->Trace(from, to, route, options, found);
}

Status PathFinder::Trace(const SurfacePoint& from, const SurfacePoint& to, const GraphRoute& route,
  const PathOptions& options, FoundPath& found) const
{
  DGG_RETURN_IF_ERROR(this->Usable);
  found = FoundPath();
  if (IsSamePoint(from, to))
  {
    found.Path.Points.push_back(from);
    found.GraphLength = 0.0;
    found.IsStraightened = options.Straighten;
    return Status::Success();
  }
  found.GraphLength = std::min(route.Length, route.Direct);
  if (found.GraphLength == Infinity)
  {
    return Status::Success();
  }
  const auto workspace = this->Workspaces->Borrow(this->Mesh, this->IsRim);
  PathTracer& tracer = workspace->Tracer;
  tracer.Begin(options.Straighten);
  DGG_RETURN_IF_ERROR(route.Direct <= route.Length
      ? tracer.Append(from, to, route.Direct)
      : this->TraceGraphEdges(tracer, from, to, route));
  found.NumberOfFallbacks = tracer.GetNumberOfFallbacks();
  this->Finish(*workspace, options, found);
  return Status::Success();
}

Status PathFinder::Link(
  const SurfacePoint& from, const SurfacePoint& to, double accuracy, Ends& ends) const
{
  const SurfacePoint* points[2] = { &from, &to };
  for (int side = 0; side < 2; ++side)
  {
    const SurfacePoint& point = *points[side];
    DGG_RETURN_IF_ERROR(point.Check(this->Mesh));
    std::vector<double> direct;
    DGG_RETURN_IF_ERROR(
      FindLinks(this->Builder, point, accuracy, { *points[1 - side] }, ends.Links[side], direct));
    ends.Direct = std::min(ends.Direct, direct[0]);
  }
  return Status::Success();
}

Status PathFinder::TraceGraphEdges(PathTracer& tracer, const SurfacePoint& from,
  const SurfacePoint& to, const GraphRoute& route) const
{
  if (!IsVertex(from))
  {
    const GraphLink& link = route.Links[0];
    DGG_RETURN_IF_ERROR(tracer.Append({ link.Vertex, link.ArrivalAngle, from, link.Length }, true));
  }
  for (std::size_t i = 0; i < route.Angles.size(); ++i)
  {
    DGG_RETURN_IF_ERROR(tracer.Append({ route.Vertices[i], route.Angles[i],
      SurfacePoint::AtVertex(route.Vertices[i + 1]), route.Lengths[i] }));
  }
  if (IsVertex(to))
  {
    return Status::Success();
  }
  const GraphLink& link = route.Links[1];
  return tracer.Append({ link.Vertex, link.ArrivalAngle, to, link.Length });
}

void PathFinder::Finish(Workspace& workspace, const PathOptions& options, FoundPath& found) const
{
  if (!options.Straighten)
  {
    for (Strip& strip : workspace.Tracer.GetStrips())
    {
      RemoveRedundantCrossings(this->Mesh, strip);
      workspace.Shortener.Append(strip, found.Path);
    }
    return;
  }
  workspace.Shortener.ForgetRim();
  workspace.Straighten(found.Path);
  if (options.Detour > 0.0)
  {
    SurfacePath path = found.Path;
    if (workspace.Corridor.Shorten(options.Detour, path))
    {
      workspace.Tracer.Begin(true);
      workspace.Tracer.Append(path);
      workspace.Straighten(path);
      found.Path = std::move(path);
    }
    found.MeetsRim = workspace.Corridor.MeetsRim();
  }
  found.MeetsRim = found.MeetsRim || workspace.Shortener.MeetsRim();
  found.IsStraightened = true;
}
}
