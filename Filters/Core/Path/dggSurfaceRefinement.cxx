// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceRefinement.h"

#include "dggFaceTriangulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <sstream>
#include <tuple>

namespace dgg
{
namespace
{
/// Points this close together on the grid are one (1e-9, as SurfacePoint snaps).
constexpr std::int64_t MergeDistance = GridPoint::One / 1000000000;
/// Rounds of splitting segments in one face before giving up. Two do, but for rounding.
constexpr int MaximumRounds = 100;

/// One vertex to be: where a path passes.
struct Node
{
  Id Edge = NoId;     // the smallest half-edge of the edge that it is on, or
  Id Face = NoId;     // the face that it is in; neither for vertices
  std::int64_t T = 0; // on an edge: from the origin, in units of 1 / One
  GridPoint Place;    // in a face
};

/// A straight piece of a path within one face.
struct Piece
{
  Id Path = NoId;
  std::vector<Id> Nodes; // its ends, and between them what it passes
};

std::int64_t Largest(const GridPoint& a, const GridPoint& b)
{
  return std::max(std::abs(a.X - b.X), std::abs(a.Y - b.Y));
}

/// Whether a point is close to a segment, between its ends.
bool IsBetween(const GridPoint& p, const GridPoint& a, const GridPoint& b)
{
  auto real = [](std::int64_t x) { return static_cast<double>(x); };
  const double ux = real(b.X - a.X);
  const double uy = real(b.Y - a.Y);
  const double vx = real(p.X - a.X);
  const double vy = real(p.Y - a.Y);
  const double square = ux * ux + uy * uy;
  const double along = ux * vx + uy * vy;
  return along > 0.0 && along < square &&
    std::abs(ux * vy - uy * vx) <= real(MergeDistance) * std::sqrt(square);
}

/// Whether the boxes around two segments meet.
bool MayMeet(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d)
{
  return std::max(a.X, b.X) >= std::min(c.X, d.X) && std::max(c.X, d.X) >= std::min(a.X, b.X) &&
    std::max(a.Y, b.Y) >= std::min(c.Y, d.Y) && std::max(c.Y, d.Y) >= std::min(a.Y, b.Y);
}

/// How far along a segment a point is, in grid units squared.
double Along(const GridPoint& p, const GridPoint& a, const GridPoint& b)
{
  auto real = [](std::int64_t x) { return static_cast<double>(x); };
  return real(b.X - a.X) * real(p.X - a.X) + real(b.Y - a.Y) * real(p.Y - a.Y);
}

GridPoint Intersection(
  const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d)
{
  auto real = [](std::int64_t x) { return static_cast<long double>(x); };
  const long double ux = real(b.X - a.X);
  const long double uy = real(b.Y - a.Y);
  const long double vx = real(d.X - c.X);
  const long double vy = real(d.Y - c.Y);
  const long double t = (real(c.X - a.X) * vy - real(c.Y - a.Y) * vx) / (ux * vy - uy * vx);
  GridPoint p{ a.X + std::llround(t * ux), a.Y + std::llround(t * uy) };
  // Not on a side: the next face knows nothing of it.
  p.X = std::max<std::int64_t>(1, std::min(p.X, GridPoint::One - 2));
  p.Y = std::max<std::int64_t>(1, std::min(p.Y, GridPoint::One - 1 - p.X));
  return p;
}

class Refiner
{
public:
  Refiner(const SurfaceMesh& mesh, const std::vector<SurfacePath>& paths,
    const RefinementOptions& options, RefinedSurface& refined)
    : Mesh(mesh)
    , Paths(paths)
    , Options(options)
    , Refined(refined)
  {
  }

  Status Run();

private:
  using EdgeMark = std::pair<Id, std::int64_t>;

  Status CheckPaths() const;
  Id CanonicalEdge(Id h) const;
  EdgeMark MarkOf(const SurfacePoint& point) const;
  void MakeEdgeNodes();
  Id NodeOf(const SurfacePoint& point);
  void MakePieces();
  GridPoint PlaceOf(Id node, Id face) const;
  bool IsInside(Id node) const
  {
    return node >= this->NumberOfVertices &&
      this->Nodes[node - this->NumberOfVertices].Face != NoId;
  }
  bool AreOnOneSide(Id a, Id b, Id face, int& side) const;
  int PositionOnSide(Id node, Id face, int side) const;
  Status SplitFace(Id f);
  bool SplitAtPoints(Piece& piece, Id f) const;
  Status SplitAtCrossings(Id f, bool& found);
  Id CrossingNode(const GridPoint& place, Id f);
  void AddWholeFace(Id f);
  Status Triangulate(Id f);
  void AddTriangle(Id f, const std::array<Id, 3>& nodes);
  void MakeTwinsAndLengths();
  double MeasureEdge(Id a, Id b, Id face) const;
  void MakePoints();
  void MakeChains();

  const SurfaceMesh& Mesh;
  const std::vector<SurfacePath>& Paths;
  const RefinementOptions& Options;
  RefinedSurface& Refined;

  Id NumberOfVertices = 0;
  std::vector<Node> Nodes;                         // after the vertices
  std::vector<EdgeMark> Marks;                     // where edges are crossed, sorted
  std::vector<Id> MarkNodes;                       // the nodes of the marks
  std::map<Id, std::vector<Id>> OnEdge;            // per edge crossed, in order
  std::map<Id, std::vector<Id>> InFace;            // nodes inside a face
  std::vector<Piece> Pieces;                       // of the paths, one after the other
  std::map<Id, std::vector<std::size_t>> PiecesIn; // per face
};

Status Refiner::Run()
{
  this->Refined = RefinedSurface();
  this->NumberOfVertices = this->Mesh.GetNumberOfVertices();
  Status status = this->CheckPaths();
  if (!status.IsOk())
  {
    return status;
  }
  this->MakeEdgeNodes();
  this->MakePieces();
  for (Id f = 0; f < this->Mesh.GetNumberOfFaces(); ++f)
  {
    if (this->Mesh.IsDropped(f))
    {
      continue;
    }
    bool isWhole =
      this->InFace.find(f) == this->InFace.end() && this->PiecesIn.find(f) == this->PiecesIn.end();
    for (Id h = 3 * f; h < 3 * f + 3 && isWhole && !this->OnEdge.empty(); ++h)
    {
      isWhole = this->OnEdge.find(this->CanonicalEdge(h)) == this->OnEdge.end();
    }
    if (isWhole)
    {
      this->AddWholeFace(f);
      continue;
    }
    status = this->SplitFace(f);
    if (status.IsOk())
    {
      status = this->Triangulate(f);
    }
    if (!status.IsOk())
    {
      this->Refined = RefinedSurface();
      return status;
    }
  }
  this->MakeTwinsAndLengths();
  this->MakePoints();
  this->MakeChains();
  return Status::Success();
}

Status Refiner::CheckPaths() const
{
  Status corners = CheckCorners(this->Mesh);
  if (!corners.IsOk())
  {
    return corners;
  }
  for (std::size_t p = 0; p < this->Paths.size(); ++p)
  {
    const SurfacePath& path = this->Paths[p];
    Status status;
    for (const SurfacePoint& point : path.Points)
    {
      status = status.IsOk() ? point.Check(this->Mesh) : status;
    }
    status = status.IsOk() ? CheckPath(this->Mesh, path) : status;
    if (!status.IsOk())
    {
      std::ostringstream message;
      message << "path " << p << ": " << status.GetMessage();
      return Status::Invalid(message.str());
    }
  }
  return Status::Success();
}

/// All half-edges of an edge have one name.
Id Refiner::CanonicalEdge(Id h) const
{
  Id smallest = h;
  for (Id e = this->Mesh.Twin(h); e != NoId && e != h; e = this->Mesh.Twin(e))
  {
    smallest = std::min(smallest, e);
  }
  return smallest;
}

Refiner::EdgeMark Refiner::MarkOf(const SurfacePoint& point) const
{
  const Id edge = this->CanonicalEdge(point.HalfEdge);
  const double t = point.Barycentric[(point.HalfEdge + 1) % 3] /
    (point.Barycentric[point.HalfEdge % 3] + point.Barycentric[(point.HalfEdge + 1) % 3]);
  const auto mark =
    static_cast<std::int64_t>(std::llround(t * static_cast<double>(GridPoint::One)));
  return { edge,
    this->Mesh.Origin(edge) == this->Mesh.Origin(point.HalfEdge) ? mark : GridPoint::One - mark };
}

/// Points on edges: those close together are one, those close to an end are the vertex there.
void Refiner::MakeEdgeNodes()
{
  for (const SurfacePath& path : this->Paths)
  {
    for (const SurfacePoint& point : path.Points)
    {
      if (point.On == SurfacePoint::Support::Edge)
      {
        this->Marks.push_back(this->MarkOf(point));
      }
    }
  }
  std::sort(this->Marks.begin(), this->Marks.end());
  this->Marks.erase(std::unique(this->Marks.begin(), this->Marks.end()), this->Marks.end());
  for (const EdgeMark& mark : this->Marks)
  {
    if (mark.second <= MergeDistance || mark.second >= GridPoint::One - MergeDistance)
    {
      this->MarkNodes.push_back(mark.second <= MergeDistance ? this->Mesh.Origin(mark.first)
                                                             : this->Mesh.Destination(mark.first));
      continue;
    }
    if (this->Nodes.empty() || this->Nodes.back().Edge != mark.first ||
      mark.second - this->Nodes.back().T > MergeDistance)
    {
      this->OnEdge[mark.first].push_back(
        this->NumberOfVertices + static_cast<Id>(this->Nodes.size()));
      Node node;
      node.Edge = mark.first;
      node.T = mark.second;
      this->Nodes.push_back(node);
    }
    this->MarkNodes.push_back(this->NumberOfVertices + static_cast<Id>(this->Nodes.size()) - 1);
  }
}

Id Refiner::NodeOf(const SurfacePoint& point)
{
  if (point.On == SurfacePoint::Support::Vertex)
  {
    return point.Vertex;
  }
  if (point.On == SurfacePoint::Support::Edge)
  {
    const auto mark = std::lower_bound(this->Marks.begin(), this->Marks.end(), this->MarkOf(point));
    return this->MarkNodes[mark - this->Marks.begin()];
  }
  Node node;
  node.Face = point.Face;
  node.Place = GridPoint::FromBarycentric(point.Barycentric);
  std::vector<Id>& others = this->InFace[point.Face];
  for (const Id other : others)
  {
    if (Largest(node.Place, this->Nodes[other - this->NumberOfVertices].Place) <= MergeDistance)
    {
      return other;
    }
  }
  others.push_back(this->NumberOfVertices + static_cast<Id>(this->Nodes.size()));
  this->Nodes.push_back(node);
  return others.back();
}

void Refiner::MakePieces()
{
  for (std::size_t p = 0; p < this->Paths.size(); ++p)
  {
    const SurfacePath& path = this->Paths[p];
    if (path.Points.empty())
    {
      continue;
    }
    Id from = this->NodeOf(path.Points[0]);
    for (std::size_t i = 0; i < path.Faces.size(); ++i)
    {
      const Id to = this->NodeOf(path.Points[i + 1]);
      if (to != from)
      {
        this->PiecesIn[path.Faces[i]].push_back(this->Pieces.size());
        this->Pieces.push_back({ static_cast<Id>(p), { from, to } });
      }
      from = to;
    }
  }
}

/// Where a node lies in one of its faces.
GridPoint Refiner::PlaceOf(Id node, Id face) const
{
  if (node < this->NumberOfVertices)
  {
    const Id k = node == this->Mesh.Origin(3 * face) ? 0
      : node == this->Mesh.Origin(3 * face + 1)      ? 1
                                                     : 2;
    return { k == 1 ? GridPoint::One : 0, k == 2 ? GridPoint::One : 0 };
  }
  const Node& n = this->Nodes[node - this->NumberOfVertices];
  if (n.Edge == NoId)
  {
    return n.Place;
  }
  Id h = 3 * face;
  while (h < 3 * face + 2 && this->CanonicalEdge(h) != n.Edge)
  {
    ++h;
  }
  std::array<std::int64_t, 3> b{ { 0, 0, 0 } };
  const bool along = this->Mesh.Origin(h) == this->Mesh.Origin(n.Edge);
  b[(h + 1) % 3] = along ? n.T : GridPoint::One - n.T;
  b[h % 3] = GridPoint::One - b[(h + 1) % 3];
  return { b[1], b[2] };
}

/// Whether two nodes lie on one side of a face, and on which: that from corner `side` to the next.
bool Refiner::AreOnOneSide(Id a, Id b, Id face, int& side) const
{
  for (side = 0; side < 3; ++side)
  {
    if (this->PositionOnSide(a, face, side) >= 0 && this->PositionOnSide(b, face, side) >= 0)
    {
      return true;
    }
  }
  return false;
}

/// Place of a node among those of a side of a face: 0 at its first corner; -1 when it is not there.
int Refiner::PositionOnSide(Id node, Id face, int side) const
{
  const Id h = 3 * face + side;
  const Id edge = this->CanonicalEdge(h);
  const auto found = this->OnEdge.find(edge);
  const int count = found == this->OnEdge.end() ? 0 : static_cast<int>(found->second.size());
  if (node == this->Mesh.Origin(h))
  {
    return 0;
  }
  if (node == this->Mesh.Destination(h))
  {
    return count + 1;
  }
  if (node < this->NumberOfVertices || this->Nodes[node - this->NumberOfVertices].Edge != edge)
  {
    return -1;
  }
  const auto place = std::find(found->second.begin(), found->second.end(), node);
  const int position = static_cast<int>(place - found->second.begin());
  return this->Mesh.Origin(edge) == this->Mesh.Origin(h) ? position + 1 : count - position;
}

/// Split the pieces in a face where they pass points and each other.
Status Refiner::SplitFace(Id f)
{
  const auto pieces = this->PiecesIn.find(f);
  if (pieces == this->PiecesIn.end())
  {
    return Status::Success();
  }
  for (int round = 0; round < MaximumRounds; ++round)
  {
    for (const std::size_t p : pieces->second)
    {
      while (this->SplitAtPoints(this->Pieces[p], f))
      {
      }
    }
    bool found = false;
    Status status = this->SplitAtCrossings(f, found);
    if (!status.IsOk() || !found)
    {
      return status;
    }
  }
  std::ostringstream message;
  message << "the crossings of paths in face " << f << " are too close together";
  return Status::Invalid(message.str());
}

/// Make a piece run through one more point that it passes. False when there is none.
bool Refiner::SplitAtPoints(Piece& piece, Id f) const
{
  const auto inside = this->InFace.find(f);
  for (std::size_t i = 0; i + 1 < piece.Nodes.size(); ++i)
  {
    const Id a = piece.Nodes[i];
    const Id b = piece.Nodes[i + 1];
    int side = 0;
    if (!this->IsInside(a) && !this->IsInside(b) && this->AreOnOneSide(a, b, f, side))
    {
      const int from = this->PositionOnSide(a, f, side);
      const int to = this->PositionOnSide(b, f, side);
      if (std::abs(from - to) > 1)
      {
        const Id edge = this->CanonicalEdge(3 * f + side);
        const std::vector<Id>& nodes = this->OnEdge.find(edge)->second;
        const int next = from < to ? from + 1 : from - 1;
        const bool along = this->Mesh.Origin(edge) == this->Mesh.Origin(3 * f + side);
        const int index = along ? next - 1 : static_cast<int>(nodes.size()) - next;
        piece.Nodes.insert(piece.Nodes.begin() + static_cast<std::ptrdiff_t>(i) + 1, nodes[index]);
        return true;
      }
      continue;
    }
    if (inside == this->InFace.end())
    {
      continue;
    }
    const GridPoint pa = this->PlaceOf(a, f);
    const GridPoint pb = this->PlaceOf(b, f);
    for (const Id node : inside->second)
    {
      if (std::find(piece.Nodes.begin(), piece.Nodes.end(), node) == piece.Nodes.end() &&
        IsBetween(this->Nodes[node - this->NumberOfVertices].Place, pa, pb))
      {
        piece.Nodes.insert(piece.Nodes.begin() + static_cast<std::ptrdiff_t>(i) + 1, node);
        return true;
      }
    }
  }
  return false;
}

/// Look for pieces that cross, and insert nodes there, or fail.
Status Refiner::SplitAtCrossings(Id f, bool& found)
{
  struct Segment
  {
    std::size_t Piece;
    std::size_t Start; // among the nodes of the piece
    GridPoint From;
    GridPoint To;
  };
  std::vector<Segment> segments;
  for (const std::size_t p : this->PiecesIn.find(f)->second)
  {
    const std::vector<Id>& nodes = this->Pieces[p].Nodes;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      segments.push_back({ p, i, this->PlaceOf(nodes[i], f), this->PlaceOf(nodes[i + 1], f) });
    }
  }
  struct Insertion
  {
    std::size_t Piece;
    std::size_t Start;
    double Along;
    Id Node;
  };
  std::vector<Insertion> insertions;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (std::size_t j = i + 1; j < segments.size(); ++j)
    {
      const Segment& p = segments[i];
      const Segment& q = segments[j];
      if (!MayMeet(p.From, p.To, q.From, q.To) || !CrossProperly(p.From, p.To, q.From, q.To))
      {
        continue;
      }
      if (!this->Options.InsertCrossings)
      {
        std::ostringstream message;
        message << "paths " << this->Pieces[p.Piece].Path << " and " << this->Pieces[q.Piece].Path
                << " cross in face " << f;
        return Status::Invalid(message.str());
      }
      const Id node = this->CrossingNode(Intersection(p.From, p.To, q.From, q.To), f);
      for (const Segment& segment : { p, q })
      {
        const std::vector<Id>& nodes = this->Pieces[segment.Piece].Nodes;
        if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
        {
          insertions.push_back({ segment.Piece, segment.Start,
            Along(this->PlaceOf(node, f), segment.From, segment.To), node });
        }
      }
    }
  }
  // From the back, so that places in the lists of nodes stay what they are.
  std::sort(
    insertions.begin(), insertions.end(), [](const Insertion& first, const Insertion& second) {
      return std::tie(first.Piece, first.Start, first.Along, first.Node) >
        std::tie(second.Piece, second.Start, second.Along, second.Node);
    });
  for (const Insertion& insertion : insertions)
  {
    std::vector<Id>& nodes = this->Pieces[insertion.Piece].Nodes;
    if (std::find(nodes.begin(), nodes.end(), insertion.Node) == nodes.end())
    {
      nodes.insert(
        nodes.begin() + static_cast<std::ptrdiff_t>(insertion.Start) + 1, insertion.Node);
    }
  }
  found = !insertions.empty();
  return Status::Success();
}

/// The node at a crossing: a new one, unless there is one so close that it would be the same.
Id Refiner::CrossingNode(const GridPoint& place, Id f)
{
  std::vector<Id>& others = this->InFace[f];
  for (const Id other : others)
  {
    if (Largest(place, this->Nodes[other - this->NumberOfVertices].Place) <= MergeDistance)
    {
      return other;
    }
  }
  Node node;
  node.Face = f;
  node.Place = place;
  others.push_back(this->NumberOfVertices + static_cast<Id>(this->Nodes.size()));
  this->Nodes.push_back(node);
  return others.back();
}

void Refiner::AddWholeFace(Id f)
{
  this->AddTriangle(f, this->Mesh.GetTriangle(f));
}

Status Refiner::Triangulate(Id f)
{
  const Id h = 3 * f;
  FaceTriangulation triangulation({ { { 0.0, 0.0 }, { this->Mesh.Length(h), 0.0 },
    { this->Mesh.ApexX(h), this->Mesh.ApexY(h) } } });
  std::vector<Id> nodes{ this->Mesh.Origin(h), this->Mesh.Origin(h + 1), this->Mesh.Origin(h + 2) };
  auto add = [&](const std::vector<Id>& more) {
    for (const Id node : more)
    {
      triangulation.AddPoint(this->PlaceOf(node, f));
      nodes.push_back(node);
    }
  };
  for (Id e = h; e < h + 3; ++e)
  {
    const auto found = this->OnEdge.find(this->CanonicalEdge(e));
    if (found != this->OnEdge.end())
    {
      add(found->second);
    }
  }
  const auto inside = this->InFace.find(f);
  if (inside != this->InFace.end())
  {
    add(inside->second);
  }
  const auto pieces = this->PiecesIn.find(f);
  if (pieces != this->PiecesIn.end())
  {
    std::map<Id, int> indices;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      indices[nodes[i]] = static_cast<int>(i);
    }
    for (const std::size_t p : pieces->second)
    {
      const std::vector<Id>& chain = this->Pieces[p].Nodes;
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      {
        if (!triangulation.AddSegment(indices[chain[i]], indices[chain[i + 1]]))
        {
          std::ostringstream message;
          message << "face " << f << " cannot be split along path " << this->Pieces[p].Path;
          return Status::Invalid(message.str());
        }
      }
    }
  }
  triangulation.MakeDelaunay();
  for (const std::array<int, 3>& t : triangulation.GetTriangles())
  {
    this->AddTriangle(f, { { nodes[t[0]], nodes[t[1]], nodes[t[2]] } });
  }
  return Status::Success();
}

void Refiner::AddTriangle(Id f, const std::array<Id, 3>& nodes)
{
  this->Refined.Triangles.insert(this->Refined.Triangles.end(), nodes.begin(), nodes.end());
  this->Refined.Faces.push_back(f);
}

/// Edges are glued where they are parts of the same old edge, or within the same old face.
void Refiner::MakeTwinsAndLengths()
{
  const auto halfEdges = static_cast<Id>(this->Refined.Triangles.size());
  const Id oldHalfEdges = this->Mesh.GetNumberOfHalfEdges();
  this->Refined.Twins.assign(halfEdges, NoId);
  this->Refined.Lengths.resize(halfEdges);
  using Key = std::tuple<Offset, Id, Id, Id>; // where, ends, half-edge
  std::vector<Key> keys;
  keys.reserve(halfEdges);
  for (Id e = 0; e < halfEdges; ++e)
  {
    const Id f = this->Refined.Faces[SurfaceMesh::Face(e)];
    const Id a = this->Refined.Triangles[e];
    const Id b = this->Refined.Triangles[SurfaceMesh::Next(e)];
    int side = 0;
    const Offset where = this->AreOnOneSide(a, b, f, side) ? this->CanonicalEdge(3 * f + side)
                                                           : static_cast<Offset>(oldHalfEdges) + f;
    keys.emplace_back(where, std::min(a, b), std::max(a, b), e);
    this->Refined.Lengths[e] = this->MeasureEdge(a, b, f);
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t begin = 0; begin < keys.size();)
  {
    std::size_t end = begin + 1;
    while (end < keys.size() && std::get<0>(keys[end]) == std::get<0>(keys[begin]) &&
      std::get<1>(keys[end]) == std::get<1>(keys[begin]) &&
      std::get<2>(keys[end]) == std::get<2>(keys[begin]))
    {
      ++end;
    }
    for (std::size_t i = begin; i < end && end - begin > 1; ++i)
    {
      this->Refined.Twins[std::get<3>(keys[i])] = std::get<3>(keys[i + 1 == end ? begin : i + 1]);
    }
    begin = end;
  }
}

double Refiner::MeasureEdge(Id a, Id b, Id face) const
{
  int side = 0;
  if (this->AreOnOneSide(a, b, face, side))
  {
    // The same bits in all faces of the edge.
    const Id edge = this->CanonicalEdge(3 * face + side);
    auto mark = [&](Id node) {
      return node == this->Mesh.Origin(edge)   ? std::int64_t(0)
        : node == this->Mesh.Destination(edge) ? GridPoint::One
                                               : this->Nodes[node - this->NumberOfVertices].T;
    };
    const std::int64_t difference = std::abs(mark(a) - mark(b));
    return difference == GridPoint::One
      ? this->Mesh.Length(edge)
      : this->Mesh.Length(edge) * (static_cast<double>(difference) / GridPoint::One);
  }
  return DistanceInFace(this->Mesh, face, this->PlaceOf(std::min(a, b), face).GetBarycentric(),
    this->PlaceOf(std::max(a, b), face).GetBarycentric());
}

void Refiner::MakePoints()
{
  std::vector<SurfacePoint>& points = this->Refined.Points;
  points.reserve(this->NumberOfVertices + this->Nodes.size());
  for (Id v = 0; v < this->NumberOfVertices; ++v)
  {
    points.push_back(SurfacePoint::AtVertex(v));
  }
  for (const Node& node : this->Nodes)
  {
    SurfacePoint point;
    if (node.Edge != NoId)
    {
      const double t = static_cast<double>(node.T) / GridPoint::One;
      point.On = SurfacePoint::Support::Edge;
      point.HalfEdge = node.Edge;
      point.Face = SurfaceMesh::Face(node.Edge);
      point.Barycentric = { { 0.0, 0.0, 0.0 } };
      point.Barycentric[node.Edge % 3] = 1.0 - t;
      point.Barycentric[(node.Edge + 1) % 3] = t;
    }
    else
    {
      point.On = SurfacePoint::Support::Face;
      point.Face = node.Face;
      point.Barycentric = node.Place.GetBarycentric();
    }
    points.push_back(point);
  }
}

void Refiner::MakeChains()
{
  std::vector<std::vector<Id>>& chains = this->Refined.Paths;
  chains.resize(this->Paths.size());
  for (const Piece& piece : this->Pieces)
  {
    std::vector<Id>& chain = chains[piece.Path];
    chain.insert(chain.end(), piece.Nodes.begin() + (chain.empty() ? 0 : 1), piece.Nodes.end());
  }
  for (std::size_t p = 0; p < this->Paths.size(); ++p)
  {
    if (chains[p].empty() && !this->Paths[p].Points.empty())
    {
      chains[p].push_back(this->NodeOf(this->Paths[p].Points[0])); // a single point
    }
  }
}
}

Status RefineAlongPaths(const SurfaceMesh& mesh, const std::vector<SurfacePath>& paths,
  const RefinementOptions& options, RefinedSurface& refined)
{
  return Refiner(mesh, paths, options, refined).Run();
}
}
