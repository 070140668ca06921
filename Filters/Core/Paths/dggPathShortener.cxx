// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPathShortener.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Angles that are smaller than pi by less than this tolerance are kept, because the possible gain
/// is of second order.
constexpr double AngleTolerance = 1e-9;
/// Maximum number of rounds without gain, which may occur by rounding errors.
constexpr int MaximumIdleRounds = 8;
/// Maximum number of rounds, each of which reroutes the strip around all bends at which the path
/// becomes shorter. Ten or twenty are common; the limit stops paths that rounding errors keep
/// moving.
constexpr int MaximumRounds = 10000;

double AngleBetween(const Point2& a, const Point2& b)
{
  return std::atan2(std::abs(Cross(a, b)), Dot(a, b));
}
}

double PathShortener::Lay(const Strip& strip)
{
  this->Work += strip.Crossings.size();
  this->Plane.Unfold(this->Mesh, strip);
  return this->TheFunnel.Run(this->Plane, this->Bends);
}

PathShortener::Corner PathShortener::CornerAt(const StripBend& bend) const
{
  const Id vertex = this->Plane.Portals[bend.Portal].Vertices[bend.Side];
  std::size_t last = bend.Portal;
  while (last + 1 < this->Plane.Portals.size() &&
    this->Plane.Portals[last + 1].Vertices[bend.Side] == vertex)
  {
    ++last;
  }
  return { vertex, bend.Side, bend.Portal, last, bend.Position };
}

double PathShortener::Shorten(Strip& strip)
{
  RemoveRedundantCrossings(this->Mesh, strip);
  double length = this->Lay(strip);
  int idle = 0; // rounds without a gain
  for (int round = 0; round < MaximumRounds && idle < MaximumIdleRounds && this->Reroute(strip);
       ++round)
  {
    RemoveRedundantCrossings(this->Mesh, strip);
    const double shorter = this->Lay(strip);
    idle = shorter < length ? 0 : idle + 1;
    length = std::min(length, shorter);
  }
  return length;
}

/// Reroutes the strip around the other side of every bend at which the path becomes shorter.
/// Returns false if there is no such bend.
bool PathShortener::Reroute(Strip& strip)
{
  this->Crossings.clear();
  std::size_t done = 0; // number of processed crossings of the strip
  bool isChanged = false;
  for (std::size_t b = 0; b < this->Bends.size(); ++b)
  {
    const Corner corner = this->CornerAt(this->Bends[b]);
    this->HasMetRim = this->HasMetRim || (this->IsRim && this->IsRim[corner.Vertex]);
    if (corner.First < done) // shares an edge with a rerouted bend: next round
    {
      continue;
    }
    const Point2& before = b == 0 ? this->Plane.Start : this->Bends[b - 1].Position;
    const Point2& after =
      b + 1 == this->Bends.size() ? this->Plane.End : this->Bends[b + 1].Position;
    if (!this->IsShorterBehind(strip, corner, before, after, this->Detour))
    {
      continue;
    }
    for (; done < corner.First; ++done)
    {
      AppendCrossing(this->Crossings, strip.Crossings[done]);
    }
    for (const EdgeCrossing& crossing : this->Detour)
    {
      AppendCrossing(this->Crossings, crossing);
    }
    done = corner.Last + 1;
    isChanged = true;
  }
  if (isChanged)
  {
    for (; done < strip.Crossings.size(); ++done)
    {
      AppendCrossing(this->Crossings, strip.Crossings[done]);
    }
    strip.Crossings.swap(this->Crossings);
  }
  return isChanged;
}

/// Returns the angle at a vertex between two points of the path, on the side of the strip.
double PathShortener::AngleInStrip(
  const Strip& strip, const Corner& corner, const Point2& before, const Point2& after) const
{
  const auto toFarEnd = [&](std::size_t portal) {
    return Difference(this->Plane.Portals[portal].Ends[1 - corner.Side], corner.Position);
  };
  double angle = AngleBetween(toFarEnd(corner.First), Difference(before, corner.Position)) +
    AngleBetween(toFarEnd(corner.Last), Difference(after, corner.Position));
  for (std::size_t i = corner.First + 1; i <= corner.Last; ++i)
  {
    angle += this->Mesh.CornerAngle(HalfEdgeFrom(this->Mesh, strip.FaceBefore(i), corner.Vertex));
  }
  return angle;
}

/// Returns true if a path that bends around a vertex becomes shorter on its other side; `detour`
/// receives the crossings on that side.
bool PathShortener::IsShorterBehind(const Strip& strip, const Corner& corner, const Point2& before,
  const Point2& after, std::vector<EdgeCrossing>& detour) const
{
  const VertexKind kind = this->Mesh.Kind(corner.Vertex);
  if (kind == VertexKind::Boundary)
  {
    return false; // there are no faces behind
  }
  const double angle = this->AngleInStrip(strip, corner, before, after);
  if (kind != VertexKind::Irregular)
  {
    return this->Mesh.TotalAngle(corner.Vertex) - angle < Pi - AngleTolerance &&
      this->WalkBehind(strip, corner, detour);
  }
  // Any turn around the vertex with an angle below pi is suitable.
  const auto toFarEnd = [&](std::size_t portal) {
    return Difference(this->Plane.Portals[portal].Ends[1 - corner.Side], corner.Position);
  };
  TurnEnd from{ strip.FaceBefore(corner.First), strip.Crossings[corner.First].Exit,
    AngleBetween(toFarEnd(corner.First), Difference(before, corner.Position)) };
  TurnEnd to{ strip.FaceBefore(corner.Last + 1), strip.Crossings[corner.Last].Entry,
    AngleBetween(toFarEnd(corner.Last), Difference(after, corner.Position)) };
  const double best = FindTurn(this->Mesh, corner.Vertex, from, to, detour);
  return best < std::min(Pi, angle) - AngleTolerance;
}

/// Collects the crossings on the other side of an interior vertex.
bool PathShortener::WalkBehind(
  const Strip& strip, const Corner& corner, std::vector<EdgeCrossing>& detour) const
{
  detour.clear();
  const Id last = strip.FaceBefore(corner.Last + 1);
  if (strip.FaceBefore(corner.First) == last)
  {
    return true;
  }
  const Id exit = OtherEdgeAt(this->Mesh, corner.Vertex, strip.Crossings[corner.First].Exit);
  Turn turn = WalkAround(this->Mesh, corner.Vertex, exit, last);
  detour.swap(turn.Crossings);
  return turn.Angle < Infinity;
}

void PathShortener::Append(const Strip& strip, SurfacePath& path)
{
  this->Lay(strip);
  if (path.Points.empty())
  {
    path.Points.push_back(strip.Start);
  }
  Id face = strip.FirstFace;
  const auto append = [&](const SurfacePoint& point) {
    const SurfacePoint& last = path.Points.back();
    if (!(IsVertex(point) && IsVertex(last) && point.Vertex == last.Vertex))
    {
      path.Append(this->Mesh, point, face);
    }
  };
  Point2 from = this->Plane.Start;
  std::size_t bend = 0;
  for (std::size_t i = 0; i < strip.Crossings.size(); ++i)
  {
    const Portal& portal = this->Plane.Portals[i];
    while (bend < this->Bends.size() && this->CornerAt(this->Bends[bend]).Last < i)
    {
      from = this->Bends[bend].Position;
      ++bend;
    }
    // Direction of the portal along the edge, in the face that is entered.
    const Id h = strip.Crossings[i].Entry;
    const bool isForward = this->Mesh.Origin(h) == portal.Vertices[StripUnfolding::Left];
    double t = 0.0; // from left to right
    if (bend < this->Bends.size() && this->Bends[bend].Portal <= i)
    {
      t = this->Bends[bend].Side == StripUnfolding::Left ? 0.0 : 1.0;
    }
    else
    {
      const Point2& to = bend < this->Bends.size() ? this->Bends[bend].Position : this->Plane.End;
      const Point2& left = portal.Ends[StripUnfolding::Left];
      const Point2& right = portal.Ends[StripUnfolding::Right];
      const Point2 ray = Difference(to, from);
      const double onLeft = Cross(ray, Difference(left, from));
      const double onRight = Cross(Difference(right, from), ray);
      t = onLeft + onRight > 0.0 ? std::min(1.0, std::max(0.0, onLeft / (onLeft + onRight))) : 0.5;
    }
    append(SurfacePoint::OnEdge(this->Mesh, h, isForward ? t : 1.0 - t));
    face = SurfaceMesh::Face(h);
  }
  append(strip.End);
}
}
