// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHopTracer.h"

#include "dggSurfacePath.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Half the width of a beam, radians. Floats below 8 are good to 2.4e-7, those below 32 (saddles of
/// five turns) to 1e-6.
constexpr double HalfWidths[] = { 1.5e-6, 1e-4 };
/// Lengths are floats as well.
constexpr double RelativeLength = 1e-6;
/// More edges than that no beam of a graph crosses, unless it runs around for ever.
constexpr std::size_t MostBeams = 1000000;
}

bool HopTracer::Trace(const Hop& hop, Id& firstFace, std::vector<EdgeCrossing>& crossings)
{
  crossings.clear();
  const double total = this->Mesh.TotalAngle(hop.Tail);
  const bool isRound = this->Mesh.Kind(hop.Tail) != VertexKind::Boundary;
  for (const double halfWidth : HalfWidths)
  {
    for (const Id* g = this->Mesh.FanBegin(hop.Tail); g != this->Mesh.FanEnd(hop.Tail); ++g)
    {
      // The direction, measured from the half-edge, within half a turn of it.
      double angle = hop.Angle - this->Mesh.PolarAngle(*g);
      if (isRound && angle > 0.5 * total)
      {
        angle -= total;
      }
      else if (isRound && angle < -0.5 * total)
      {
        angle += total;
      }
      if (angle < -halfWidth || angle > this->Mesh.CornerAngle(*g) + halfWidth)
      {
        continue;
      }
      if (this->TraceFrom(hop, *g, angle, halfWidth))
      {
        firstFace = SurfaceMesh::Face(*g);
        for (Id i = this->Found; i != NoId; i = this->Beams[i].Before)
        {
          crossings.push_back(this->Beams[i].Crossing);
        }
        std::reverse(crossings.begin(), crossings.end());
        return true;
      }
    }
  }
  return false;
}

/// Through the face of the outgoing half-edge g, whose frame becomes that of the plane.
bool HopTracer::TraceFrom(const Hop& hop, Id g, double angle, double halfWidth)
{
  this->Beams.clear();
  this->Open.clear();
  this->Found = NoId;
  this->Rays[0] = { std::cos(angle + halfWidth), std::sin(angle + halfWidth) };
  this->Rays[1] = { std::cos(angle - halfWidth), std::sin(angle - halfWidth) };
  std::array<double, 3> barycentric{};
  if (FindInFace(this->Mesh, hop.Head, SurfaceMesh::Face(g), barycentric))
  {
    const Point2 head = PlaceInFrame(this->Mesh, g, barycentric);
    if (std::abs(Norm(head.X, head.Y) - hop.Length) <= RelativeLength * hop.Length)
    {
      return true;
    }
  }
  const Id across = SurfaceMesh::Next(g);
  const FaceUnfolding face(this->Mesh.Length(g), { this->Mesh.ApexX(g), this->Mesh.ApexY(g) },
    this->Mesh.Length(SurfaceMesh::Previous(g)), this->Mesh.Length(across));
  this->Cross(across, false, face.GetApex(), { face.GetRightCosine(), -face.GetRightSine() }, NoId);
  while (!this->Open.empty() && this->Beams.size() < MostBeams)
  {
    const Id index = this->Open.back();
    this->Open.pop_back();
    if (this->Reaches(hop, this->Beams[index]))
    {
      this->Found = index;
      return true;
    }
    this->Continue(hop, index);
  }
  return false;
}

/// Into all faces behind an edge.
void HopTracer::Cross(Id exit, bool mirrored, const Point2& left, const Point2& axis, Id before)
{
  const Id leftVertex = mirrored ? this->Mesh.Origin(exit) : this->Mesh.Destination(exit);
  for (Id e = this->Mesh.Twin(exit); e != NoId && e != exit; e = this->Mesh.Twin(e))
  {
    this->Open.push_back(static_cast<Id>(this->Beams.size()));
    this->Beams.push_back({ { exit, e }, this->Mesh.Origin(e) != leftVertex, left, axis, before });
  }
}

/// Whether the head lies in the face that is entered, in the beam and at the right distance.
bool HopTracer::Reaches(const Hop& hop, const Beam& beam) const
{
  const Id h = beam.Crossing.Entry;
  std::array<double, 3> barycentric{};
  if (!FindInFace(this->Mesh, hop.Head, SurfaceMesh::Face(h), barycentric))
  {
    return false;
  }
  Point2 p = PlaceInFrame(this->Mesh, h, barycentric);
  p.X = beam.IsMirrored ? this->Mesh.Length(h) - p.X : p.X;
  p = FromFrame(beam.Left, beam.Axis, p);
  return std::abs(Norm(p.X, p.Y) - hop.Length) <= RelativeLength * hop.Length &&
    dgg::Cross(p, this->Rays[0]) >= 0.0 && dgg::Cross(this->Rays[1], p) >= 0.0;
}

void HopTracer::Continue(const Hop& hop, Id index)
{
  const Beam beam = this->Beams[index];
  const Id h = beam.Crossing.Entry;
  const Id leftEdge = beam.IsMirrored ? SurfaceMesh::Next(h) : SurfaceMesh::Previous(h);
  const Id rightEdge = beam.IsMirrored ? SurfaceMesh::Previous(h) : SurfaceMesh::Next(h);
  const double x =
    beam.IsMirrored ? this->Mesh.Length(h) - this->Mesh.ApexX(h) : this->Mesh.ApexX(h);
  const FaceUnfolding face(this->Mesh.Length(h), { x, this->Mesh.ApexY(h) },
    this->Mesh.Length(leftEdge), this->Mesh.Length(rightEdge));
  const Point2 apex = FromFrame(beam.Left, beam.Axis, face.GetApex());
  const double farEnough = hop.Length * (1.0 + RelativeLength);
  const auto isNear = [&](const Point2& start, const Point2& axis, double length) {
    // Distance from the tail to the edge.
    const double t = std::min(length, std::max(0.0, -Dot(start, axis)));
    return Norm(start.X + t * axis.X, start.Y + t * axis.Y) <= farEnough;
  };
  if (dgg::Cross(apex, this->Rays[0]) > 0.0) // the left ray passes on the left of the apex
  {
    const Point2 axis = Turned(beam.Axis, { face.GetLeftCosine(), face.GetLeftSine() });
    if (isNear(beam.Left, axis, face.GetLeft()))
    {
      this->Cross(leftEdge, beam.IsMirrored, beam.Left, axis, index);
    }
  }
  if (dgg::Cross(this->Rays[1], apex) > 0.0)
  {
    const Point2 axis = Turned(beam.Axis, { face.GetRightCosine(), -face.GetRightSine() });
    if (isNear(apex, axis, face.GetRight()))
    {
      this->Cross(rightEdge, beam.IsMirrored, apex, axis, index);
    }
  }
}
}
