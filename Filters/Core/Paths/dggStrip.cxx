// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggStrip.h"

#include "dggEdges.h"
#include "dggSurfacePath.h"

#include <algorithm>
#include <array>
#include <utility>

namespace dgg
{
namespace
{
bool IsOnEdge(const SurfaceMesh& mesh, const SurfacePoint& point, Id h)
{
  if (IsVertex(point))
  {
    return mesh.Origin(h) == point.Vertex || mesh.Destination(h) == point.Vertex;
  }
  return point.On == SurfacePoint::Support::Edge &&
    FindEdge(mesh, point.HalfEdge) == FindEdge(mesh, h);
}
}

Turn WalkAround(const SurfaceMesh& mesh, Id c, Id exit, Id toFace)
{
  Turn turn;
  double angle = 0.0;
  const Id start = SurfaceMesh::Face(exit);
  for (;;)
  {
    const Id entry = mesh.Twin(exit);
    if (entry == NoId || SurfaceMesh::Face(entry) == start)
    {
      return turn;
    }
    turn.Crossings.push_back({ exit, entry });
    const Id face = SurfaceMesh::Face(entry);
    if (face == toFace)
    {
      turn.Angle = angle;
      return turn;
    }
    angle += mesh.CornerAngle(HalfEdgeFrom(mesh, face, c));
    exit = OtherEdgeAt(mesh, c, entry);
  }
}

void Reverse(std::vector<EdgeCrossing>& crossings)
{
  std::reverse(crossings.begin(), crossings.end());
  for (EdgeCrossing& crossing : crossings)
  {
    std::swap(crossing.Exit, crossing.Entry);
  }
}

void AppendCrossing(std::vector<EdgeCrossing>& crossings, const EdgeCrossing& crossing)
{
  if (crossings.empty() || crossings.back().Entry != crossing.Exit)
  {
    crossings.push_back(crossing);
    return;
  }
  // Back over the same edge, to the previous face or to a third one.
  const Id exit = crossings.back().Exit;
  crossings.pop_back();
  if (exit != crossing.Entry)
  {
    AppendCrossing(crossings, { exit, crossing.Entry });
  }
}

/// Dijkstra's algorithm over the few edges around the vertex, including non-manifold ones.
double FindTurn(const SurfaceMesh& mesh, Id c, const TurnEnd& from, const TurnEnd& to,
  std::vector<EdgeCrossing>& crossings)
{
  struct Step
  {
    double Angle;
    std::size_t Before;
    EdgeCrossing Crossing;
    bool IsDone;
  };
  std::vector<Step> steps;
  const std::size_t none = static_cast<std::size_t>(-1);
  const auto leave = [&](Id exit, double angle, std::size_t before) {
    ForEachTwin(mesh, exit, [&](Id e) {
      const auto known = std::find_if(
        steps.begin(), steps.end(), [&](const Step& other) { return other.Crossing.Entry == e; });
      const Step next{ angle, before, { exit, e }, false };
      if (known == steps.end())
      {
        steps.push_back(next);
      }
      else if (angle < known->Angle)
      {
        *known = next;
      }
    });
  };
  const auto corner = [&](Id face) { return mesh.CornerAngle(HalfEdgeFrom(mesh, face, c)); };
  /// Returns the angle in the last face if this face is entered through its half-edge e.
  const auto inLast = [&](Id e) {
    return e == to.HalfEdge ? to.Angle : std::max(0.0, corner(to.Face) - to.Angle);
  };
  leave(from.HalfEdge, from.Angle, none);
  leave(OtherEdgeAt(mesh, c, from.HalfEdge), std::max(0.0, corner(from.Face) - from.Angle), none);
  double best = Infinity;
  std::size_t last = none;
  if (from.Face == to.Face)
  {
    best = std::abs(from.Angle - inLast(from.HalfEdge));
  }
  for (;;)
  {
    std::size_t nearest = none;
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      if (!steps[i].IsDone && (nearest == none || steps[i].Angle < steps[nearest].Angle))
      {
        nearest = i;
      }
    }
    if (nearest == none || steps[nearest].Angle >= best)
    {
      break;
    }
    steps[nearest].IsDone = true;
    const Step step = steps[nearest];
    const Id face = SurfaceMesh::Face(step.Crossing.Entry);
    if (face == to.Face && step.Angle + inLast(step.Crossing.Entry) < best)
    {
      best = step.Angle + inLast(step.Crossing.Entry);
      last = nearest;
    }
    leave(OtherEdgeAt(mesh, c, step.Crossing.Entry), step.Angle + corner(face), nearest);
  }
  crossings.clear();
  for (; last != none; last = steps[last].Before)
  {
    crossings.push_back(steps[last].Crossing);
  }
  std::reverse(crossings.begin(), crossings.end());
  return best;
}

bool AppendTurn(
  const SurfaceMesh& mesh, Id c, Id fromFace, Id toFace, std::vector<EdgeCrossing>& crossings)
{
  if (fromFace == toFace)
  {
    return true;
  }
  Turn best;
  if (mesh.Kind(c) == VertexKind::Irregular)
  {
    const Id g = HalfEdgeFrom(mesh, fromFace, c);
    const Id h = HalfEdgeFrom(mesh, toFace, c);
    best.Angle = FindTurn(mesh, c, { fromFace, g, 0.5 * mesh.CornerAngle(g) },
      { toFace, h, 0.5 * mesh.CornerAngle(h) }, best.Crossings);
  }
  else
  {
    const Id g = HalfEdgeFrom(mesh, fromFace, c);
    best = WalkAround(mesh, c, g, toFace);
    Turn other = WalkAround(mesh, c, SurfaceMesh::Previous(g), toFace);
    if (other.Angle < best.Angle)
    {
      best = std::move(other);
    }
  }
  if (best.Angle == Infinity)
  {
    return false;
  }
  for (const EdgeCrossing& crossing : best.Crossings)
  {
    AppendCrossing(crossings, crossing);
  }
  return true;
}

Id HalfEdgeUnder(const SurfaceMesh& mesh, const SurfacePoint& point, Id face)
{
  std::array<double, 3> barycentric{};
  if (point.On == SurfacePoint::Support::Edge && FindInFace(mesh, point, face, barycentric))
  {
    for (Id h = 3 * face; h < 3 * face + 3; ++h)
    {
      if (barycentric[(h + 2) % 3] == 0.0)
      {
        return h;
      }
    }
  }
  return NoId;
}

void RemoveRedundantCrossings(const SurfaceMesh& mesh, Strip& strip)
{
  std::vector<EdgeCrossing>& crossings = strip.Crossings;
  std::size_t first = 0;
  while (first < crossings.size() && IsOnEdge(mesh, strip.Start, crossings[first].Entry))
  {
    strip.FirstFace = SurfaceMesh::Face(crossings[first].Entry);
    ++first;
  }
  crossings.erase(crossings.begin(), crossings.begin() + static_cast<std::ptrdiff_t>(first));
  while (!crossings.empty() && IsOnEdge(mesh, strip.End, crossings.back().Entry))
  {
    crossings.pop_back();
  }
}

void StripChain::Append(const Strip& strip)
{
  if (!this->Strips.empty() && (this->IsJoining || !IsVertex(strip.Start)))
  {
    Strip& last = this->Strips.back();
    const Id from = last.LastFace();
    if (from == strip.FirstFace ||
      (IsVertex(strip.Start) &&
        AppendTurn(this->Mesh, strip.Start.Vertex, from, strip.FirstFace, last.Crossings)))
    {
      for (const EdgeCrossing& crossing : strip.Crossings)
      {
        AppendCrossing(last.Crossings, crossing);
      }
      last.End = strip.End;
      return;
    }
  }
  this->Strips.push_back(strip);
}

void StripChain::Append(const SurfacePath& path)
{
  for (std::size_t i = 0; i < path.Faces.size(); ++i)
  {
    this->AppendPiece(path.Points[i], path.Points[i + 1], path.Faces[i]);
  }
}

void StripChain::AppendPiece(const SurfacePoint& from, const SurfacePoint& to, Id face)
{
  Strip piece;
  piece.Start = from;
  piece.End = to;
  piece.FirstFace = face;
  if (!this->Strips.empty() && !IsVertex(from))
  {
    Strip& last = this->Strips.back();
    const Id exit = HalfEdgeUnder(this->Mesh, from, last.LastFace());
    const Id entry = HalfEdgeUnder(this->Mesh, from, face);
    if (exit != NoId && entry != NoId && exit != entry)
    {
      AppendCrossing(last.Crossings, { exit, entry });
    }
  }
  this->Append(piece);
}
}
