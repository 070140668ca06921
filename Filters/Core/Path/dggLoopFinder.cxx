// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLoopFinder.h"

#include "dggHomotopyBasis.h"
#include "dggLoopCandidates.h"
#include "dggLoopShortener.h"
#include "dggPathTracer.h"
#include "dggStripChain.h"

#include <algorithm>
#include <utility>

namespace dgg
{
namespace
{
/// Ways there and back that are straightened, one after the other, until one stays open; most of
/// those that contract to a point are left out before.
constexpr std::size_t MostTrials = 256;
/// Of links into a graph that has none.
constexpr double DefaultAccuracy = 0.01;
/// Once there is a loop, longer ones are tried that may become shorter than it.
constexpr std::size_t MostRivals = 24;

/// A ring of the faces that a closed path runs through. False when it passes through a vertex in
/// which faces meet in nothing else: there it cannot be moved.
bool MakeRing(const SurfaceMesh& mesh, const SurfacePath& path, std::vector<EdgeCrossing>& ring)
{
  StripChain chain(mesh);
  chain.Append(path);
  if (chain.GetStrips().size() != 1)
  {
    return false;
  }
  const Strip& strip = chain.GetStrips().front();
  ring = strip.Crossings;
  const Id from = strip.LastFace();
  const SurfacePoint& start = strip.Start;
  if (from == strip.FirstFace)
  {
    return true;
  }
  if (IsVertex(start))
  {
    return AppendTurn(mesh, start.Vertex, from, strip.FirstFace, ring);
  }
  const Id exit = HalfEdgeUnder(mesh, start, from);
  const Id entry = HalfEdgeUnder(mesh, start, strip.FirstFace);
  if (exit == NoId || entry == NoId)
  {
    return false;
  }
  AppendCrossing(ring, { exit, entry });
  return true;
}

/// Let a closed path go where it starts, and pull it tight.
void Tighten(const SurfaceMesh& mesh, FoundLoop& loop)
{
  std::vector<EdgeCrossing> ring;
  SurfacePath tight;
  if (MakeRing(mesh, loop.Loop, ring))
  {
    LoopShortener(mesh).Shorten(std::move(ring), tight);
  }
  loop.Loop = std::move(tight);
  loop.Angle = Pi;
}

/// Loops around handles, and which of them are independent.
class HandleLoops
{
public:
  HandleLoops(const SurfaceMesh& mesh, const HomologySignatures& signatures)
    : Mesh(mesh)
    , Signatures(signatures)
  {
  }

  /// The shortest loops of edges through a vertex, pulled tight.
  void AddLoopsThrough(Id base)
  {
    this->Bases.push_back(base);
    std::vector<EdgeLoop> basis;
    if (!FindHomotopyBasis(this->Mesh, base, basis).IsOk())
    {
      return;
    }
    for (const EdgeLoop& edges : basis)
    {
      Candidate candidate;
      candidate.Signature = this->Signatures.GetSignature(edges);
      SurfacePath& path = candidate.Found.Loop;
      for (std::size_t i = 0; i < edges.Vertices.size(); ++i)
      {
        path.Points.push_back(SurfacePoint::AtVertex(edges.Vertices[i]));
        path.Faces.push_back(SurfaceMesh::Face(edges.HalfEdges[i]));
      }
      path.Points.push_back(path.Points.front());
      path.Length = edges.Length;
      Tighten(this->Mesh, candidate.Found);
      if (!candidate.Found.Loop.IsEmpty())
      {
        this->Candidates.push_back(std::move(candidate));
      }
    }
  }

  /// Which loops are shortest through a vertex depends on where that is: far from a handle, a loop
  /// around it may as well take in another one. Close to a loop, those that cross it are found.
  void AddLoopsThroughLoops()
  {
    const std::size_t count = this->Candidates.size();
    const std::size_t places = std::max<std::size_t>(1, std::min(BasesPerLoop, MostBases / count));
    for (std::size_t i = 0; i < count && this->Bases.size() <= MostBases; ++i)
    {
      for (std::size_t k = 0; k < places; ++k)
      {
        const SurfacePath& path = this->Candidates[i].Found.Loop;
        const Id face = path.Faces[k * path.Faces.size() / places];
        const Id base = this->Mesh.Origin(3 * face);
        if (std::find(this->Bases.begin(), this->Bases.end(), base) == this->Bases.end())
        {
          this->AddLoopsThrough(base);
        }
      }
    }
  }

  /// Independent ones, the shortest first.
  std::vector<FoundLoop> TakeShortest()
  {
    std::stable_sort(
      this->Candidates.begin(), this->Candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.Found.Loop.Length < b.Found.Loop.Length;
      });
    std::vector<FoundLoop> loops;
    std::vector<std::vector<char>> rows; // in echelon form
    for (Candidate& candidate : this->Candidates)
    {
      std::vector<char> row = candidate.Signature;
      for (const std::vector<char>& other : rows)
      {
        const auto pivot = std::find(other.begin(), other.end(), 1) - other.begin();
        if (row[pivot])
        {
          std::transform(row.begin(), row.end(), other.begin(), row.begin(),
            [](char a, char b) { return static_cast<char>(a ^ b); });
        }
      }
      if (std::find(row.begin(), row.end(), 1) != row.end())
      {
        rows.push_back(std::move(row));
        loops.push_back(std::move(candidate.Found));
      }
    }
    return loops;
  }

private:
  struct Candidate
  {
    FoundLoop Found;
    std::vector<char> Signature;
  };

  static constexpr std::size_t BasesPerLoop = 4;
  static constexpr std::size_t MostBases = 16;

  const SurfaceMesh& Mesh;
  const HomologySignatures& Signatures;
  std::vector<Candidate> Candidates;
  std::vector<Id> Bases;
};
}

//------------------------------------------------------------------------------
class LoopFinder::Implementation
{
public:
  Implementation(const SurfaceMesh& mesh, const GraphSearch& search, const GraphBuilder* builder,
    const double* positions)
    : Mesh(mesh)
    , Search(search)
    , Builder(builder)
    , Paths(mesh, search, builder, positions)
  {
  }

  Status ThroughPoint(const SurfacePoint& point, bool taut, FoundLoop& loop) const;

  const SurfaceMesh& Mesh;
  const GraphSearch& Search;
  const GraphBuilder* Builder;
  PathFinder Paths;

private:
  /// A search from the point that loops go through.
  struct Tree
  {
    SurfacePoint Point;
    std::vector<GraphSeed> Seeds;
    SearchResult Result;
  };

  Status Grow(Tree& tree) const;
  Status TraceBranch(PathTracer& tracer, const Tree& tree, Id vertex, bool isOutwards) const;
  Status Trace(PathTracer& tracer, const Tree& tree, const LoopCandidate& candidate) const;
};

/// Paths from the point to all vertices.
Status LoopFinder::Implementation::Grow(Tree& tree) const
{
  Status status = tree.Point.Check(this->Mesh);
  if (status.IsOk() && !this->Search.GetGraph().Angles)
  {
    status = Status::Invalid("loops are traced on meshes: this graph has no directions");
  }
  if (!status.IsOk())
  {
    return status;
  }
  if (IsVertex(tree.Point))
  {
    tree.Seeds.push_back({ tree.Point.Vertex, 0.0, 0.0, 0, -1.0 });
  }
  else if (!this->Builder)
  {
    return Status::Invalid("a point that is not a vertex needs a graph builder");
  }
  else
  {
    std::vector<GraphLink> links;
    std::vector<double> direct;
    const double accuracy = this->Search.GetGraph().Info.Accuracy;
    status = this->Builder->Link(
      tree.Point, accuracy > 0.0 ? accuracy : DefaultAccuracy, {}, links, direct);
    for (const GraphLink& link : links)
    {
      tree.Seeds.push_back({ link.Vertex, link.Length, 0.0, 0, link.ArrivalAngle });
    }
  }
  return status.IsOk() ? this->Search.Run(tree.Seeds, SearchOptions(), tree.Result) : status;
}

/// The way from the point to a vertex, or back.
Status LoopFinder::Implementation::TraceBranch(
  PathTracer& tracer, const Tree& tree, Id vertex, bool isOutwards) const
{
  const GraphView& graph = this->Search.GetGraph();
  std::vector<Hop> hops; // from the vertex to the point; the tail of each is nearer to the point
  Id v = vertex;
  for (; tree.Result.Edges[v] >= 0; v = tree.Result.Tails[v])
  {
    const Offset e = tree.Result.Edges[v];
    hops.push_back(
      { tree.Result.Tails[v], graph.Angles[e], SurfacePoint::AtVertex(v), graph.Length(e) });
  }
  const GraphSeed& seed = tree.Seeds[tree.Result.Seeds[v]];
  const Hop link{ v, seed.ArrivalAngle, tree.Point, seed.Distance };
  Status status;
  if (isOutwards)
  {
    if (!IsVertex(tree.Point))
    {
      status = tracer.Append(link, true);
    }
    for (auto hop = hops.rbegin(); hop != hops.rend() && status.IsOk(); ++hop)
    {
      status = tracer.Append(*hop);
    }
    return status;
  }
  for (auto hop = hops.begin(); hop != hops.end() && status.IsOk(); ++hop)
  {
    status = tracer.Append(*hop, true);
  }
  return status.IsOk() && !IsVertex(tree.Point) ? tracer.Append(link) : status;
}

Status LoopFinder::Implementation::Trace(
  PathTracer& tracer, const Tree& tree, const LoopCandidate& candidate) const
{
  const GraphView& graph = this->Search.GetGraph();
  const Id head = graph.Targets[candidate.Edge];
  tracer.Begin(true);
  Status status = this->TraceBranch(tracer, tree, candidate.Tail, true);
  if (status.IsOk())
  {
    status = tracer.Append({ candidate.Tail, graph.Angles[candidate.Edge],
      SurfacePoint::AtVertex(head), graph.Length(candidate.Edge) });
  }
  return status.IsOk() ? this->TraceBranch(tracer, tree, head, false) : status;
}

Status LoopFinder::Implementation::ThroughPoint(
  const SurfacePoint& point, bool taut, FoundLoop& loop) const
{
  Tree tree;
  tree.Point = point;
  Status status = this->Grow(tree);
  if (!status.IsOk())
  {
    return status;
  }
  const GraphView& graph = this->Search.GetGraph();
  const std::vector<LoopCandidate> candidates =
    FindLoopCandidates(this->Mesh, graph, tree.Seeds, tree.Result);
  PathTracer tracer(this->Mesh);
  PathShortener shortener(this->Mesh);
  std::size_t rivals = 0;
  for (std::size_t i = 0; i < candidates.size() && i < MostTrials && rivals < MostRivals; ++i)
  {
    const bool isFound = !loop.Loop.IsEmpty();
    // A loop is shorter than its way through the graph by the accuracy at most.
    if (isFound && candidates[i].Length > loop.Loop.Length * (1.0 + graph.Info.Accuracy))
    {
      break;
    }
    rivals += isFound ? 1 : 0;
    status = this->Trace(tracer, tree, candidates[i]);
    if (!status.IsOk())
    {
      return status;
    }
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
    found.Angle = LoopShortener::AngleAtStart(this->Mesh, found.Loop);
    if (taut)
    {
      Tighten(this->Mesh, found);
    }
    if (!found.Loop.IsEmpty() && (!isFound || found.Loop.Length < loop.Loop.Length))
    {
      loop = std::move(found);
    }
  }
  return status;
}

LoopFinder::LoopFinder(const SurfaceMesh& mesh, const GraphSearch& search,
  const GraphBuilder* builder, const double* positions)
  : Internals(std::make_unique<Implementation>(mesh, search, builder, positions))
{
}

LoopFinder::~LoopFinder() = default;

Status LoopFinder::ThroughPoint(const SurfacePoint& point, bool taut, FoundLoop& loop) const
{
  loop = FoundLoop();
  const Status status = this->Internals->ThroughPoint(point, taut, loop);
  if (!status.IsOk())
  {
    loop = FoundLoop();
  }
  return status;
}

Status LoopFinder::AroundHandles(Id base, std::vector<FoundLoop>& loops) const
{
  loops.clear();
  const SurfaceMesh& mesh = this->Internals->Mesh;
  const Status exists = SurfacePoint::AtVertex(base).Check(mesh);
  if (!exists.IsOk())
  {
    return exists;
  }
  const HomologySignatures signatures(mesh, base);
  if (!signatures.Check().IsOk() || signatures.GetDimension() == 0)
  {
    return signatures.Check();
  }
  HandleLoops found(mesh, signatures);
  found.AddLoopsThrough(base);
  found.AddLoopsThroughLoops();
  loops = found.TakeShortest();
  return Status::Success();
}

Status LoopFinder::Rope(const std::vector<SurfacePoint>& points, bool taut, FoundLoop& loop) const
{
  loop = FoundLoop();
  if (points.empty())
  {
    return Status::Invalid("a rope needs points to go through");
  }
  SurfacePath rope;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    FoundPath leg;
    const Status status =
      this->Internals->Paths.Find(points[i], points[(i + 1) % points.size()], PathOptions(), leg);
    if (!status.IsOk() || leg.Path.IsEmpty())
    {
      return status;
    }
    const std::size_t first = rope.Points.empty() ? 0 : 1;
    rope.Points.insert(rope.Points.end(),
      leg.Path.Points.begin() + static_cast<std::ptrdiff_t>(first), leg.Path.Points.end());
    rope.Faces.insert(rope.Faces.end(), leg.Path.Faces.begin(), leg.Path.Faces.end());
    rope.Length += leg.Path.Length;
  }
  if (rope.Faces.empty())
  {
    return Status::Success();
  }
  loop.Loop = std::move(rope);
  if (taut)
  {
    Tighten(this->Internals->Mesh, loop);
  }
  else
  {
    loop.Angle = LoopShortener::AngleAtStart(this->Internals->Mesh, loop.Loop);
  }
  return Status::Success();
}
}
