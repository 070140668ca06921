// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPathFinder.h"

#include "dggExactPath.h"
#include "dggHopTracer.h"
#include "dggPathCorridor.h"
#include "dggPathShortener.h"
#include "dggStripChain.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace dgg
{
namespace
{
/// Lengths of edges are floats.
constexpr double FloatTolerance = 1e-6;

/// What the finder of one path works with.
struct PathWorkspace
{
  explicit PathWorkspace(const SurfaceMesh& mesh)
    : Tracer(mesh)
    , Shortener(mesh)
    , Chain(mesh)
    , Corridor(mesh)
    , Mesh(mesh)
  {
  }

  HopTracer Tracer;
  PathShortener Shortener;
  StripChain Chain;
  PathCorridor Corridor;

  /// The exact way between points close together, made when it is first needed. False when there
  /// is none within `length`.
  bool FindExactly(
    const SurfacePoint& from, const SurfacePoint& to, double length, SurfacePath& path)
  {
    if (!this->Exact)
    {
      this->Exact = std::make_unique<ExactPathFinder>(this->Mesh);
    }
    std::vector<SurfacePath> found;
    const bool isFound =
      this->Exact->Find(from, { to }, ProgressCallback(), found, length * (1.0 + FloatTolerance))
        .IsOk() &&
      !found.front().IsEmpty();
    if (isFound)
    {
      path = std::move(found.front());
    }
    return isFound;
  }

private:
  const SurfaceMesh& Mesh;
  std::unique_ptr<ExactPathFinder> Exact;
};

/// Replace a path by the one in the chain, shortened.
void Straighten(PathWorkspace& workspace, SurfacePath& path)
{
  path.Clear();
  for (Strip& strip : workspace.Chain.GetStrips())
  {
    workspace.Shortener.Shorten(strip);
    workspace.Shortener.Append(strip, path);
  }
}

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

  Status Link(const SurfacePoint& from, const SurfacePoint& to, double accuracy, Ends& ends) const;
  Status TraceDirect(PathWorkspace& workspace, const SurfacePoint& from, const SurfacePoint& to,
    double length) const;
  Status TraceHop(
    PathWorkspace& workspace, const Hop& hop, bool isBackwards, Id& numberOfFallbacks) const;
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
  const double linkAccuracy =
    options.LinkAccuracy > 0.0 ? options.LinkAccuracy : this->Search.GetGraph().Info.Accuracy;
  Ends ends;
  Status status = this->Link(from, to, linkAccuracy, ends);
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
  found.GraphLength = std::min(path.Length, ends.Direct);
  if (found.GraphLength == Infinity)
  {
    return status;
  }
  const auto workspace = this->Workspaces.Borrow(this->Mesh);
  workspace->Chain.Clear(options.Straighten);
  status = ends.Direct <= path.Length ? this->TraceDirect(*workspace, from, to, ends.Direct)
                                      : this->TraceHops(*workspace, from, to, ends, path, found);
  if (status.IsOk())
  {
    this->Finish(*workspace, options, found);
  }
  return status;
}

Status PathFinder::Implementation::Link(
  const SurfacePoint& from, const SurfacePoint& to, double accuracy, Ends& ends) const
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
      status =
        this->Builder->Link(point, accuracy, { *points[1 - side] }, ends.Links[side], direct);
      ends.Direct = status.IsOk() ? std::min(ends.Direct, direct[0]) : Infinity;
    }
    if (!status.IsOk())
    {
      return status;
    }
  }
  return Status::Success();
}

/// The straight way between two points that are not vertices.
Status PathFinder::Implementation::TraceDirect(
  PathWorkspace& workspace, const SurfacePoint& from, const SurfacePoint& to, double length) const
{
  SurfacePath path;
  Id shared = NoId;
  ForEachFaceAround(this->Mesh, from, [&](Id f, const std::array<double, 3>& p) {
    std::array<double, 3> q{};
    if (FindInFace(this->Mesh, to, f, q) && DistanceInFace(this->Mesh, f, p, q) <= length)
    {
      shared = f;
    }
  });
  if (shared != NoId)
  {
    path.Points = { from, to };
    path.Faces = { shared };
  }
  else if (!workspace.FindExactly(from, to, length, path))
  {
    return Status::Invalid("the straight way between two points cannot be traced");
  }
  workspace.Chain.Append(path);
  return Status::Success();
}

/// The strip of an edge of the graph.
Status PathFinder::Implementation::TraceHop(
  PathWorkspace& workspace, const Hop& hop, bool isBackwards, Id& numberOfFallbacks) const
{
  Strip strip;
  strip.Start = SurfacePoint::AtVertex(hop.Tail);
  strip.End = hop.Head;
  if (!workspace.Tracer.Trace(hop, strip.FirstFace, strip.Crossings))
  {
    ++numberOfFallbacks;
    SurfacePath path;
    if (!workspace.FindExactly(isBackwards ? strip.End : strip.Start,
          isBackwards ? strip.Start : strip.End, hop.Length, path))
    {
      return Status::Invalid("an edge of the graph, from vertex " + std::to_string(hop.Tail) +
        ", cannot be traced on the surface: the graph is not that of the mesh");
    }
    workspace.Chain.Append(path);
    return Status::Success();
  }
  if (isBackwards)
  {
    strip.FirstFace = strip.LastFace();
    std::swap(strip.Start, strip.End);
    Reverse(strip.Crossings);
  }
  workspace.Chain.Append(strip);
  return Status::Success();
}

Status PathFinder::Implementation::TraceHops(PathWorkspace& workspace, const SurfacePoint& from,
  const SurfacePoint& to, const Ends& ends, const GraphPath& path, FoundPath& found) const
{
  const GraphView& graph = this->Search.GetGraph();
  Status status;
  if (!IsVertex(from))
  {
    const GraphLink& link = ends.Links[0][path.FromSeed];
    status = this->TraceHop(workspace, { link.Vertex, link.ArrivalAngle, from, link.Length }, true,
      found.NumberOfFallbacks);
  }
  for (std::size_t i = 0; i < path.Edges.size() && status.IsOk(); ++i)
  {
    const Offset e = path.Edges[i];
    status = this->TraceHop(workspace,
      { path.Vertices[i], graph.Angles[e], SurfacePoint::AtVertex(path.Vertices[i + 1]),
        graph.Length(e) },
      false, found.NumberOfFallbacks);
  }
  if (!IsVertex(to) && status.IsOk())
  {
    const GraphLink& link = ends.Links[1][path.ToSeed];
    status = this->TraceHop(workspace, { link.Vertex, link.ArrivalAngle, to, link.Length }, false,
      found.NumberOfFallbacks);
  }
  return status;
}

void PathFinder::Implementation::Finish(
  PathWorkspace& workspace, const PathOptions& options, FoundPath& found) const
{
  if (!options.Straighten)
  {
    for (Strip& strip : workspace.Chain.GetStrips())
    {
      Tidy(this->Mesh, strip);
      workspace.Shortener.Append(strip, found.Path);
    }
    return;
  }
  Straighten(workspace, found.Path);
  if (options.Detour > 0.0)
  {
    SurfacePath path = found.Path;
    if (workspace.Corridor.Shorten(options.Detour, path))
    {
      workspace.Chain.Clear();
      workspace.Chain.Append(path);
      Straighten(workspace, path);
      found.Path = std::move(path);
    }
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
