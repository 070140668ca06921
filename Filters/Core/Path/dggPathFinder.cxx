// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPathFinder.h"

#include "dggHopTracer.h"
#include "dggPathShortener.h"
#include "dggStripChain.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <utility>

namespace dgg
{
namespace
{
/// What the finder of one path works with.
struct PathWorkspace
{
  explicit PathWorkspace(const SurfaceMesh& mesh)
    : Tracer(mesh)
    , Shortener(mesh)
    , Chain(mesh)
  {
  }

  HopTracer Tracer;
  PathShortener Shortener;
  StripChain Chain;
  std::vector<Strip> Hops;
};

bool AreEqual(const SurfacePoint& a, const SurfacePoint& b)
{
  if (IsVertex(a) || IsVertex(b))
  {
    return a.On == b.On && a.Vertex == b.Vertex;
  }
  return a.Face == b.Face && a.Barycentric == b.Barycentric;
}
}

//------------------------------------------------------------------------------
class PathFinder::Implementation
{
public:
  Implementation(const SurfaceMesh& mesh, const GraphSearch& search, const GraphBuilder* builder,
    const double* positions)
    : Mesh(mesh)
    , Search(search)
    , Builder(builder)
    , Positions(positions)
  {
  }

  Status Find(const SurfacePoint& from, const SurfacePoint& to, const PathOptions& options,
    FoundPath& found) const;

private:
  /// How a point is linked to the graph.
  struct Ends
  {
    std::vector<GraphLink> Links[2]; ///< of the first and the last point
    double Direct = Infinity;        ///< length of the straight way between them
  };

  Status Link(const SurfacePoint& from, const SurfacePoint& to, Ends& ends) const;
  bool TraceHop(PathWorkspace& workspace, const Hop& hop, Strip& strip) const;
  Status TraceHops(PathWorkspace& workspace, const SurfacePoint& from, const SurfacePoint& to,
    const Ends& ends, const GraphPath& path, FoundPath& found) const;
  void Finish(PathWorkspace& workspace, const PathOptions& options, FoundPath& found) const;

  const SurfaceMesh& Mesh;
  const GraphSearch& Search;
  const GraphBuilder* Builder;
  const double* Positions;
  mutable WorkspacePool<PathWorkspace> Workspaces;
};

Status PathFinder::Implementation::Find(const SurfacePoint& from, const SurfacePoint& to,
  const PathOptions& options, FoundPath& found) const
{
  Ends ends;
  Status status = this->Link(from, to, ends);
  if (!status.IsOk())
  {
    return status;
  }
  if (AreEqual(from, to))
  {
    found.Path.Points.push_back(from);
    found.GraphLength = 0.0;
    found.IsStraightened = options.Straighten;
    return status;
  }
  std::vector<GraphSeed> seeds[2];
  for (int side = 0; side < 2; ++side)
  {
    for (const GraphLink& link : ends.Links[side])
    {
      seeds[side].push_back({ link.Vertex, link.Length, 0.0, 0, link.ArrivalAngle });
    }
  }
  GraphPath path;
  status = this->Search.Between(seeds[0], seeds[1], this->Positions, path);
  if (!status.IsOk())
  {
    return status;
  }
  found.GraphLength = path.Length;
  if (path.Length == Infinity)
  {
    return status;
  }
  const auto workspace = this->Workspaces.Borrow(this->Mesh);
  status = this->TraceHops(*workspace, from, to, ends, path, found);
  if (status.IsOk())
  {
    this->Finish(*workspace, options, found);
  }
  return status;
}

Status PathFinder::Implementation::Link(
  const SurfacePoint& from, const SurfacePoint& to, Ends& ends) const
{
  const SurfacePoint* points[2] = { &from, &to };
  for (int side = 0; side < 2; ++side)
  {
    const SurfacePoint& point = *points[side];
    Status status = point.Check(this->Mesh);
    if (status.IsOk() && !IsVertex(point) && !this->Builder)
    {
      status = Status::Invalid("a point that is not a vertex needs a graph builder");
    }
    if (status.IsOk() && IsVertex(point))
    {
      ends.Links[side].push_back({ point.Vertex, 0.0, -1.0 });
    }
    else if (status.IsOk())
    {
      std::vector<double> direct;
      status = this->Builder->Link(point, this->Search.GetGraph().Info.Accuracy,
        { *points[1 - side] }, ends.Links[side], direct);
      ends.Direct = status.IsOk() ? std::min(ends.Direct, direct[0]) : Infinity;
    }
    if (!status.IsOk())
    {
      return status;
    }
  }
  return Status::Success();
}

/// The strip of an edge of the graph.
bool PathFinder::Implementation::TraceHop(
  PathWorkspace& workspace, const Hop& hop, Strip& strip) const
{
  strip.Start = SurfacePoint::AtVertex(hop.Tail);
  strip.End = hop.Head;
  return workspace.Tracer.Trace(hop, strip.FirstFace, strip.Crossings);
}

Status PathFinder::Implementation::TraceHops(PathWorkspace& workspace, const SurfacePoint& from,
  const SurfacePoint& to, const Ends& ends, const GraphPath& path, FoundPath& found) const
{
  const GraphView& graph = this->Search.GetGraph();
  workspace.Hops.clear();
  const auto add = [&](const Hop& hop, bool isBackwards) {
    Strip strip;
    if (!this->TraceHop(workspace, hop, strip))
    {
      ++found.NumberOfFallbacks;
      return;
    }
    if (isBackwards)
    {
      strip.FirstFace = strip.LastFace();
      std::swap(strip.Start, strip.End);
      Reverse(strip.Crossings);
    }
    workspace.Hops.push_back(std::move(strip));
  };
  if (!IsVertex(from))
  {
    const GraphLink& link = ends.Links[0][path.FromSeed];
    add({ link.Vertex, link.ArrivalAngle, from, link.Length }, true);
  }
  for (std::size_t i = 0; i < path.Edges.size(); ++i)
  {
    const Offset e = path.Edges[i];
    add({ path.Vertices[i], graph.Angles[e], SurfacePoint::AtVertex(path.Vertices[i + 1]),
          graph.Length(e) },
      false);
  }
  if (!IsVertex(to))
  {
    const GraphLink& link = ends.Links[1][path.ToSeed];
    add({ link.Vertex, link.ArrivalAngle, to, link.Length }, false);
  }
  return Status::Success();
}

void PathFinder::Implementation::Finish(
  PathWorkspace& workspace, const PathOptions& options, FoundPath& found) const
{
  if (!options.Straighten)
  {
    for (Strip& hop : workspace.Hops)
    {
      Tidy(this->Mesh, hop);
      workspace.Shortener.Append(hop, found.Path);
    }
    return;
  }
  workspace.Chain.Clear();
  for (const Strip& hop : workspace.Hops)
  {
    workspace.Chain.Append(hop);
  }
  for (Strip& strip : workspace.Chain.GetStrips())
  {
    workspace.Shortener.Shorten(strip);
    workspace.Shortener.Append(strip, found.Path);
  }
  found.IsStraightened = true;
}

//------------------------------------------------------------------------------
PathFinder::PathFinder(const SurfaceMesh& mesh, const GraphSearch& search,
  const GraphBuilder* builder, const double* positions)
  : Internals(std::make_unique<Implementation>(mesh, search, builder, positions))
{
}

PathFinder::~PathFinder() = default;

Status PathFinder::Find(const SurfacePoint& from, const SurfacePoint& to,
  const PathOptions& options, FoundPath& found) const
{
  found = FoundPath();
  const Status status = this->Internals->Find(from, to, options, found);
  if (!status.IsOk())
  {
    found = FoundPath();
  }
  return status;
}
}
