// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLoopFinder.h"

#include "dggGraphSeeds.h"
#include "dggLoopCandidates.h"
#include "dggLoopShortener.h"
#include "dggPathTracer.h"

#include <algorithm>
#include <utility>

namespace dgg
{
namespace
{
/// Maximum number of candidates that are straightened until a candidate does not contract. Most
/// candidates that contract to a point are excluded beforehand.
constexpr std::size_t MostTrials = 256;
/// Accuracy of links into a graph without an accuracy.
constexpr double DefaultAccuracy = 0.01;
double ChooseLinkAccuracy(double wanted, const GraphView& graph)
{
  const double accuracy = wanted > 0.0 ? wanted : graph.Info.Accuracy;
  return accuracy > 0.0 ? accuracy : DefaultAccuracy;
}

/// Maximum number of further candidates that do not contract. Once a loop is found, further
/// candidates that may become shorter are tried up to this number.
constexpr std::size_t MostRivals = 24;
/// Maximum number of unfolded crossings for all candidates, per face. The number is only exceeded
/// on prisms of hundreds of strips, where all candidates are rerouted around the caps strip by
/// strip, and contract.
constexpr std::size_t MostWorkOfFace = 600;
constexpr std::size_t SmallestMesh = 3000; // minimum number of faces for the limit

/// Releases a loop at its required points and shortens it. A loop that is straight at these points
/// is already a geodesic. A loop that is straight within the kink tolerance is kept if it would
/// contract to a point.
void Relax(const SurfaceMesh& mesh, FoundLoop& loop)
{
  if (loop.Angle >= Pi - LoopShortener::AngleTolerance)
  {
    return;
  }
  SurfacePath tight;
  LoopShortener(mesh).PullTight(loop.Loop, tight);
  if (tight.IsEmpty() && !loop.IsKinked())
  {
    return;
  }
  loop.Loop = std::move(tight);
  loop.Angle = Pi;
}
}

//------------------------------------------------------------------------------
class LoopFinder::Implementation
{
public:
  Implementation(const SurfaceMesh& mesh, const GraphSearch& search, const GraphBuilder* builder,
    const double* positions, double linkAccuracy)
    : Mesh(mesh)
    , Search(search)
    , Builder(builder)
    , Paths(mesh, search, builder, positions)
    , LinkAccuracy(ChooseLinkAccuracy(linkAccuracy, search.GetGraph()))
    , Usable(CheckCorners(mesh))
  {
  }

  Status ThroughPoint(
    const SurfacePoint& point, bool taut, const ProgressCallback& progress, FoundLoop& loop) const;

  const SurfaceMesh& Mesh;
  const GraphSearch& Search;
  const GraphBuilder* Builder;
  PathFinder Paths;
  const double LinkAccuracy;
  Status Usable; // error if the mesh cannot be used

private:
  /// A search from the point through which loops pass.
  struct Tree
  {
    SurfacePoint Point;
    std::vector<GraphSeed> Seeds;
    SearchResult Result;
  };

  Status Grow(Tree& tree) const;
  Status TraceBranch(PathTracer& tracer, const Tree& tree, Id vertex, bool isOutwards) const;
  Status TryCandidates(const Tree& tree, LoopCandidates& candidates, bool taut,
    const ProgressCallback& progress, FoundLoop& loop) const;
  Status Trace(PathTracer& tracer, const Tree& tree, const LoopCandidate& candidate) const;
};

/// Computes paths from the point to all vertices.
Status LoopFinder::Implementation::Grow(Tree& tree) const
{
  DGG_RETURN_IF_ERROR(this->Usable);
  DGG_RETURN_IF_ERROR(tree.Point.Check(this->Mesh));
  if (!this->Search.GetGraph().Angles)
  {
    return InvalidInput("The graph has no directions, which loops need")
      .Fix("Use the graph of a mesh");
  }
  std::vector<GraphLink> links;
  std::vector<double> none;
  DGG_RETURN_IF_ERROR(FindLinks(this->Builder, tree.Point, this->LinkAccuracy, {}, links, none));
  tree.Seeds = MakeSeeds(links);
  return this->Search.Run(tree.Seeds, SearchOptions(), tree.Result);
}

/// Traces the path from the point to a vertex, or back.
Status LoopFinder::Implementation::TraceBranch(
  PathTracer& tracer, const Tree& tree, Id vertex, bool isOutwards) const
{
  const GraphView& graph = this->Search.GetGraph();
  // The path is traced from the vertex to the point; the tail of each edge is nearer to the point.
  std::vector<GraphEdge> edges;
  Id v = vertex;
  for (; tree.Result.Edges[v] >= 0; v = tree.Result.Tails[v])
  {
    const Offset e = tree.Result.Edges[v];
    edges.push_back(
      { tree.Result.Tails[v], graph.Angles[e], SurfacePoint::AtVertex(v), graph.Length(e) });
  }
  const GraphSeed& seed = tree.Seeds[tree.Result.Seeds[v]];
  const GraphEdge link{ v, seed.ArrivalAngle, tree.Point, seed.Distance };
  const bool hasLink = !IsVertex(tree.Point);
  if (isOutwards)
  {
    std::reverse(edges.begin(), edges.end());
    DGG_RETURN_IF_ERROR(hasLink ? tracer.Append(link, true) : Status::Success());
  }
  for (const GraphEdge& edge : edges)
  {
    DGG_RETURN_IF_ERROR(tracer.Append(edge, !isOutwards));
  }
  return hasLink && !isOutwards ? tracer.Append(link) : Status::Success();
}

Status LoopFinder::Implementation::Trace(
  PathTracer& tracer, const Tree& tree, const LoopCandidate& candidate) const
{
  const GraphView& graph = this->Search.GetGraph();
  const Id head = graph.Targets[candidate.Edge];
  tracer.Begin(true);
  DGG_RETURN_IF_ERROR(this->TraceBranch(tracer, tree, candidate.Tail, true));
  DGG_RETURN_IF_ERROR(tracer.Append({ candidate.Tail, graph.Angles[candidate.Edge],
    SurfacePoint::AtVertex(head), graph.Length(candidate.Edge) }));
  return this->TraceBranch(tracer, tree, head, false);
}

Status LoopFinder::Implementation::ThroughPoint(
  const SurfacePoint& point, bool taut, const ProgressCallback& progress, FoundLoop& loop) const
{
  if (progress && !progress(0.0))
  {
    return Status::Abort(); // before the graph is used
  }
  Tree tree;
  tree.Point = point;
  DGG_RETURN_IF_ERROR(this->Grow(tree));
  LoopCandidates candidates =
    FindLoopCandidates(this->Mesh, this->Search.GetGraph(), tree.Seeds, tree.Result);
  return this->TryCandidates(tree, candidates, taut, progress, loop);
}

/// Straightens candidates. Candidates with large kinks contract to the point more often.
Status LoopFinder::Implementation::TryCandidates(const Tree& tree, LoopCandidates& candidates,
  bool taut, const ProgressCallback& progress, FoundLoop& loop) const
{
  PathTracer tracer(this->Mesh);
  PathShortener shortener(this->Mesh);
  const std::size_t mostWork = MostWorkOfFace *
    std::max(SmallestMesh, static_cast<std::size_t>(this->Mesh.GetNumberOfFaces()));
  // A loop is shorter than its graph path by at most the accuracy.
  const auto isTooLong = [&](const LoopCandidate& candidate) {
    return !loop.Loop.IsEmpty() &&
      candidate.Length > loop.Loop.Length * (1.0 + this->Search.GetGraph().Info.Accuracy);
  };
  std::size_t trials = 0;
  std::size_t rivals = 0;
  for (std::vector<LoopCandidate>* list : { &candidates.Narrow, &candidates.Wide })
  {
    list->erase(std::remove_if(list->begin(), list->end(), isTooLong), list->end());
    std::stable_sort(list->begin(), list->end(),
      [](const LoopCandidate& a, const LoopCandidate& b) { return a.Length < b.Length; });
    for (const LoopCandidate& candidate : *list)
    {
      const bool isFound = !loop.Loop.IsEmpty();
      if (isTooLong(candidate) || trials == MostTrials || rivals == MostRivals ||
        shortener.GetWork() > mostWork)
      {
        break;
      }
      if (progress && !progress(static_cast<double>(trials) / MostTrials))
      {
        return Status::Abort();
      }
      ++trials;
      DGG_RETURN_IF_ERROR(this->Trace(tracer, tree, candidate));
      FoundLoop found;
      for (Strip& strip : tracer.GetStrips())
      {
        shortener.Shorten(strip);
        shortener.Append(strip, found.Loop);
      }
      if (found.Loop.Faces.size() < 2 || !(found.Loop.Length > 0.0))
      {
        continue; // contracted to the point
      }
      rivals += isFound ? 1 : 0;
      found.Angle = LoopShortener::AngleAt(this->Mesh, found.Loop, 0);
      if (taut)
      {
        Relax(this->Mesh, found);
      }
      if (!found.Loop.IsEmpty() && (!isFound || found.Loop.Length < loop.Loop.Length))
      {
        loop = std::move(found);
      }
    }
  }
  return Status::Success();
}

LoopFinder::LoopFinder(const SurfaceMesh& mesh, const GraphSearch& search,
  const GraphBuilder* builder, const double* positions, double linkAccuracy)
  : Internals(std::make_unique<Implementation>(mesh, search, builder, positions, linkAccuracy))
{
}

LoopFinder::~LoopFinder() = default;

Status LoopFinder::ThroughPoint(
  const SurfacePoint& point, bool taut, FoundLoop& loop, const ProgressCallback& progress) const
{
  loop = FoundLoop();
  Status status = this->Internals->ThroughPoint(point, taut, progress, loop);
  if (!status.IsOk())
  {
    loop = FoundLoop();
  }
  return status;
}

Status LoopFinder::Rope(const std::vector<SurfacePoint>& points, bool taut, FoundLoop& loop,
  bool& isConnected, const ProgressCallback& progress) const
{
  loop = FoundLoop();
  isConnected = true;
  if (points.empty())
  {
    return InvalidInput("The rope has no points").Fix("Add points");
  }
  PathOptions options;
  options.LinkAccuracy = this->Internals->LinkAccuracy;
  SurfacePath rope;
  std::vector<std::size_t> stops; // segments that start at the points
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (progress && !progress(static_cast<double>(i) / static_cast<double>(points.size())))
    {
      return Status::Abort();
    }
    FoundPath leg;
    DGG_RETURN_IF_ERROR(
      this->Internals->Paths.Find(points[i], points[(i + 1) % points.size()], options, leg));
    if (leg.Path.IsEmpty())
    {
      isConnected = false;
      return Status::Success();
    }
    if (!leg.Path.Faces.empty())
    {
      stops.push_back(rope.Faces.size());
    }
    const std::size_t first = rope.Points.empty() ? 0 : 1;
    rope.Points.insert(rope.Points.end(),
      leg.Path.Points.begin() + static_cast<std::ptrdiff_t>(first), leg.Path.Points.end());
    rope.Faces.insert(rope.Faces.end(), leg.Path.Faces.begin(), leg.Path.Faces.end());
    rope.Length += leg.Path.Length;
  }
  if (progress && !progress(1.0))
  {
    return Status::Abort();
  }
  if (rope.Faces.empty())
  {
    return Status::Success();
  }
  loop.Loop = std::move(rope);
  for (const std::size_t stop : stops)
  {
    loop.Angle =
      std::min(loop.Angle, LoopShortener::AngleAt(this->Internals->Mesh, loop.Loop, stop));
  }
  if (taut)
  {
    Relax(this->Internals->Mesh, loop);
  }
  return Status::Success();
}
}
