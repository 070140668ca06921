// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLoopShortener.h"

#include "dggFoundLoop.h"
#include "dggStrip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
/// Tolerance within which positions on the cut edge count as its ends.
constexpr double EndTolerance = 1e-12;
/// Maximum number of bisections of the edge.
constexpr int MaximumHalvings = 60;
/// Maximum number of rounds without gain, which may occur by rounding errors.
constexpr int MaximumIdleRounds = 8;
/// Limit for paths that rounding errors keep moving.
constexpr int MaximumRounds = 10000;

Point2 Between(const Point2* ends, double t)
{
  return { ends[0].X + t * (ends[1].X - ends[0].X), ends[0].Y + t * (ends[1].Y - ends[0].Y) };
}

/// Returns the cosine of the angle between a segment and an edge, times the length of the edge.
double Along(const Point2& from, const Point2& to, const Point2* edge)
{
  const Point2 ray = Difference(to, from);
  const double length = Norm(ray.X, ray.Y);
  return length > 0.0 ? Dot(ray, Difference(edge[1], edge[0])) / length : 0.0;
}

/// Returns the direction in which a path leaves or reaches a vertex, within a face.
TurnEnd DirectionAt(const SurfaceMesh& mesh, Id vertex, const SurfacePoint& other, Id face)
{
  const Id g = HalfEdgeFrom(mesh, face, vertex);
  std::array<double, 3> barycentric{ { 1.0, 0.0, 0.0 } };
  FindInFace(mesh, other, face, barycentric);
  const Point2 p = PlaceInFrame(mesh, g, barycentric);
  return { face, g, std::atan2(p.Y, p.X) };
}

/// Computes the ring of faces of a closed path. Returns false if the path passes through a vertex
/// in which faces only touch, because the path cannot be moved at such a vertex.
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
}

bool LoopShortener::PullTight(const SurfacePath& path, SurfacePath& loop)
{
  loop.Clear();
  std::vector<EdgeCrossing> ring;
  return MakeRing(this->Mesh, path, ring) && this->Shorten(std::move(ring), loop);
}

bool LoopShortener::Shorten(std::vector<EdgeCrossing> ring, SurfacePath& loop)
{
  SurfacePath spare;
  if (!this->Tighten(ring, loop, spare))
  {
    loop = std::move(spare);
  }
  return !loop.IsEmpty();
}

/// Shortens the path. Returns false if the path contracts to a point; then `spare` is the first
/// intermediate path that was nearly straight, if any.
bool LoopShortener::Tighten(std::vector<EdgeCrossing>& ring, SurfacePath& loop, SurfacePath& spare)
{
  double length = Infinity;
  int idle = 0; // rounds without a gain
  for (int round = 0; round < MaximumRounds && idle < MaximumIdleRounds; ++round)
  {
    CloseUp(ring);
    if (ring.empty())
    {
      return false;
    }
    this->CutAt(ring);
    const double t = this->Minimize();
    std::size_t place = 0;
    const Id vertex = this->FindBend(ring, t, place);
    double straight = t;
    const double kink = vertex == NoId ? 0.0 : this->FindStraight(straight);
    if (kink < AngleTolerance)
    {
      this->AppendStraight(ring, straight, loop);
      return true;
    }
    if (kink < FoundLoop::KinkTolerance && spare.IsEmpty())
    {
      this->AppendStraight(ring, straight, spare);
    }
    Strip open;
    if (!this->OpenAt(ring, vertex, place, open))
    {
      return false;
    }
    this->Shortener.Shorten(open);
    if (open.Crossings.empty())
    {
      return false;
    }
    loop.Clear();
    this->Shortener.Append(open, loop);
    idle = loop.Length < length ? 0 : idle + 1;
    length = std::min(length, loop.Length);
    std::vector<EdgeCrossing> turn;
    const std::size_t last = loop.Faces.size() - 1;
    const double angle = FindTurn(this->Mesh, vertex,
      DirectionAt(this->Mesh, vertex, loop.Points[last], loop.Faces[last]),
      DirectionAt(this->Mesh, vertex, loop.Points[1], loop.Faces[0]), turn);
    if (!(angle < Pi - AngleTolerance))
    {
      return true;
    }
    ring = open.Crossings;
    for (const EdgeCrossing& crossing : turn)
    {
      AppendCrossing(ring, crossing);
    }
  }
  return true;
}

double LoopShortener::AngleAt(const SurfaceMesh& mesh, const SurfacePath& loop, std::size_t piece)
{
  if (loop.Faces.empty())
  {
    return Pi;
  }
  const std::size_t before = (piece > 0 ? piece : loop.Faces.size()) - 1;
  const SurfacePoint& previous = loop.Points[before];
  const SurfacePoint& start = loop.Points[piece];
  const SurfacePoint& next = loop.Points[piece + 1];
  const Id in = loop.Faces[before];
  const Id out = loop.Faces[piece];
  if (IsVertex(start))
  {
    std::vector<EdgeCrossing> turn;
    return std::min(Pi,
      FindTurn(mesh, start.Vertex, DirectionAt(mesh, start.Vertex, previous, in),
        DirectionAt(mesh, start.Vertex, next, out), turn));
  }
  // Returns a direction in the plane of the faces around the point, as the angle with the edge that
  // contains the point.
  const auto direction = [&](const SurfacePoint& other, Id face, Id h) {
    std::array<double, 3> p{};
    std::array<double, 3> q{};
    FindInFace(mesh, start, face, p);
    FindInFace(mesh, other, face, q);
    const Point2 from = PlaceInFrame(mesh, h, p);
    const Point2 to = PlaceInFrame(mesh, h, q);
    return std::atan2(to.Y - from.Y, to.X - from.X);
  };
  const Id outEdge = HalfEdgeUnder(mesh, start, out);
  const Id inEdge = HalfEdgeUnder(mesh, start, in);
  const bool isSame = out == in;
  double angle = direction(next, out, isSame ? 3 * out : outEdge);
  const double back = direction(previous, in, isSame ? 3 * in : inEdge);
  if (isSame)
  {
    angle = std::abs(angle - back);
  }
  else
  {
    const bool isAgainst = mesh.Origin(outEdge) != mesh.Origin(inEdge);
    angle += isAgainst ? Pi - back : back;
  }
  return std::min(angle, 2.0 * Pi - angle);
}

/// Removes edges crossed back and forth at the position where the ring closes.
void LoopShortener::CloseUp(std::vector<EdgeCrossing>& ring)
{
  while (ring.size() > 1 && ring.back().Entry == ring.front().Exit)
  {
    const EdgeCrossing last = ring.back();
    ring.pop_back();
    if (last.Exit == ring.front().Entry)
    {
      ring.erase(ring.begin());
    }
    else
    {
      ring.front().Exit = last.Exit;
    }
  }
  if (ring.size() == 1)
  {
    ring.clear(); // leaves and enters a face through the same edge
  }
}

void LoopShortener::CutAt(const std::vector<EdgeCrossing>& ring)
{
  const EdgeCrossing& first = ring.front();
  Strip& open = this->TheCut.Open;
  open.FirstFace = SurfaceMesh::Face(first.Entry);
  open.Crossings.assign(ring.begin() + 1, ring.end());
  const Id ends[2] = { this->Mesh.Origin(first.Entry), this->Mesh.Destination(first.Entry) };
  for (int k = 0; k < 2; ++k)
  {
    open.Start = SurfacePoint::AtVertex(ends[k]);
    open.End = SurfacePoint::AtVertex(ends[k]);
    this->Plane.Unfold(this->Mesh, open);
    this->TheCut.Starts[k] = this->Plane.Start;
    this->TheCut.Ends[k] = this->Plane.End;
  }
}

/// Lays out the shortest closed path through position t of the edge.
double LoopShortener::LayAt(double t)
{
  this->Plane.Start = Between(this->TheCut.Starts, t);
  this->Plane.End = Between(this->TheCut.Ends, t);
  return this->TheFunnel.Run(this->Plane, this->Bends);
}

/// Returns the derivative of the length with respect to t.
double LoopShortener::SlopeAt(double t)
{
  this->LayAt(t);
  const Point2& second = this->Bends.empty() ? this->Plane.End : this->Bends.front().Position;
  const Point2& last = this->Bends.empty() ? this->Plane.Start : this->Bends.back().Position;
  return Along(last, this->Plane.End, this->TheCut.Ends) -
    Along(this->Plane.Start, second, this->TheCut.Starts);
}

/// Minimizes the length over t. The length is convex in t, because an unrolled ring of faces is
/// flat, and in flat strips the distance between two points that move along lines is convex.
double LoopShortener::Minimize()
{
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < MaximumHalvings && high - low > 0.1 * EndTolerance; ++i)
  {
    const double middle = 0.5 * (low + high);
    const double slope = this->SlopeAt(middle);
    if (slope == 0.0)
    {
      return middle;
    }
    (slope > 0.0 ? high : low) = middle;
  }
  const double t = 0.5 * (low + high);
  this->LayAt(t);
  return t;
}

/// Finds the position t at which a straight closed path within the ring crosses the edge. If such a
/// path exists, the two copies of the edge are parallel, and so are all such paths; the middle path
/// keeps away from vertices, into which rounding errors might push other paths. Returns the angle
/// between the copies, which is the kink of the path; Infinity if no path counts as straight.
double LoopShortener::FindStraight(double& t)
{
  const Cut& cut = this->TheCut;
  const Point2 edge = Difference(cut.Starts[1], cut.Starts[0]);
  const Point2 end = Difference(cut.Ends[1], cut.Ends[0]);
  const Point2 way = Difference(cut.Ends[0], cut.Starts[0]);
  const double kink = std::atan2(std::abs(Cross(edge, end)), Dot(edge, end));
  if (!(kink < FoundLoop::KinkTolerance))
  {
    return Infinity;
  }
  const auto across = [&](const Point2& p) { return Cross(way, Difference(p, cut.Starts[0])); };
  const double span = across(cut.Starts[1]);
  double low = std::min(0.0, span);
  double high = std::max(0.0, span);
  for (const Portal& portal : this->Plane.Portals)
  {
    low = std::max(low, across(portal.Ends[StripUnfolding::Right]));
    high = std::min(high, across(portal.Ends[StripUnfolding::Left]));
  }
  if (!(high - low > EndTolerance * std::abs(span)))
  {
    return Infinity;
  }
  t = 0.5 * (low + high) / span;
  this->LayAt(t);
  return this->Bends.empty() ? kink : Infinity;
}

/// Returns a vertex around which the path bends, and the index of a crossing of an edge at this
/// vertex; NoId if the path has no bend.
Id LoopShortener::FindBend(
  const std::vector<EdgeCrossing>& ring, double t, std::size_t& place) const
{
  if (!this->Bends.empty())
  {
    const StripBend& bend = this->Bends[this->Bends.size() / 2];
    place = bend.Portal + 1;
    return this->Plane.Portals[bend.Portal].Vertices[bend.Side];
  }
  place = 0;
  const Id entry = ring.front().Entry;
  if (t < EndTolerance)
  {
    return this->Mesh.Origin(entry);
  }
  return t > 1.0 - EndTolerance ? this->Mesh.Destination(entry) : NoId;
}

bool LoopShortener::IsAt(Id vertex, const EdgeCrossing& crossing) const
{
  return this->Mesh.Origin(crossing.Entry) == vertex ||
    this->Mesh.Destination(crossing.Entry) == vertex;
}

/// Cuts the ring open at a vertex, and stores the strip without the edges at the vertex in `open`.
/// `place` is the index of one of the crossings at the vertex. Returns false if all crossed edges
/// are at the vertex, because the path then contracts to it.
bool LoopShortener::OpenAt(
  const std::vector<EdgeCrossing>& ring, Id vertex, std::size_t place, Strip& open) const
{
  const std::size_t count = ring.size();
  std::size_t after = place; // the first crossing behind the vertex
  std::size_t steps = 0;
  while (steps < count && this->IsAt(vertex, ring[after]))
  {
    after = (after + 1) % count;
    ++steps;
  }
  if (steps == count)
  {
    return false;
  }
  open.Start = SurfacePoint::AtVertex(vertex);
  open.End = open.Start;
  open.Crossings.clear();
  open.FirstFace = SurfaceMesh::Face(ring[(after + count - 1) % count].Entry);
  std::size_t before = place; // the first crossing of the run
  while (this->IsAt(vertex, ring[(before + count - 1) % count]))
  {
    before = (before + count - 1) % count;
  }
  for (std::size_t i = after; i != before; i = (i + 1) % count)
  {
    open.Crossings.push_back(ring[i]);
  }
  return true;
}

/// Appends a path without bends.
void LoopShortener::AppendStraight(
  const std::vector<EdgeCrossing>& ring, double t, SurfacePath& loop)
{
  loop.Clear();
  Strip open = this->TheCut.Open;
  open.Start = SurfacePoint::OnEdge(this->Mesh, ring.front().Entry, t);
  open.End = open.Start;
  this->Shortener.Append(open, loop);
}
}
