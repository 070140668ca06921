// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggStripUnfolding.h"

#include "dggSurfacePath.h"

#include <algorithm>
#include <array>
#include <utility>

namespace dgg
{
namespace
{
/// Returns the position of a point in the frame of half-edge h or, if `mirrored`, in the frame
/// of the reversed edge.
Point2 Place(const SurfaceMesh& mesh, const SurfacePoint& point, Id h, bool mirrored)
{
  std::array<double, 3> barycentric{ { 1.0, 0.0, 0.0 } };
  FindInFace(mesh, point, SurfaceMesh::Face(h), barycentric);
  return PlaceInEntered(mesh, h, mirrored, PlaceInFrame(mesh, h, barycentric));
}
}

/// Invariant: the current face lies on the left of `axis`, which runs from `origin` along its entry
/// edge (half-edge h), from left to right. Directions are rotated by the angles of the faces,
/// because differences of distant points would lose the precision of tiny edges.
void StripUnfolding::Unfold(const SurfaceMesh& mesh, const Strip& strip)
{
  this->Portals.clear();
  Id h = 3 * strip.FirstFace;
  bool mirrored = false;
  Point2 origin{ 0.0, 0.0 };
  Point2 axis{ 1.0, 0.0 };
  this->Start = Place(mesh, strip.Start, h, mirrored);
  if (!strip.Crossings.empty() && strip.Crossings.front().Exit == h)
  {
    h = SurfaceMesh::Next(h); // the first face has no entry edge
    this->Start = Place(mesh, strip.Start, h, mirrored);
  }
  for (const EdgeCrossing& crossing : strip.Crossings)
  {
    const EnteredFace entered(mesh, h, mirrored);
    const FaceUnfolding& face = entered.Plane;
    const bool isLeft = crossing.Exit == entered.LeftEdge;
    if (isLeft)
    {
      axis = Turned(axis, { face.GetLeftCosine(), face.GetLeftSine() });
    }
    else
    {
      origin = FromFrame(origin, axis, face.GetApex());
      axis = Turned(axis, { face.GetRightCosine(), -face.GetRightSine() });
    }
    const double length = isLeft ? face.GetLeft() : face.GetRight();
    Portal portal;
    portal.Ends = { { origin, { origin.X + length * axis.X, origin.Y + length * axis.Y } } };
    portal.Vertices = { { mesh.Destination(crossing.Exit), mesh.Origin(crossing.Exit) } };
    if (mirrored)
    {
      std::swap(portal.Vertices[Left], portal.Vertices[Right]);
    }
    h = crossing.Entry;
    mirrored = mesh.Origin(h) != portal.Vertices[Left];
    this->Portals.push_back(portal);
  }
  this->End = FromFrame(origin, axis, Place(mesh, strip.End, h, mirrored));
}

namespace
{
/// A path touches a vertex if it is this close, as an angle.
constexpr double TouchAngle = 1e-13;

/// Returns true if the shortest path from a to c bends around b, or at least touches it, where b is
/// on the given side of the strip. Touched vertices count, because their other side may be shorter.
bool BendsAround(const Point2& a, const Point2& b, const Point2& c, int side)
{
  const Point2 in = Difference(b, a);
  const Point2 out = Difference(c, b);
  const double turn = side == StripUnfolding::Left ? Cross(in, out) : -Cross(in, out);
  const double product = Dot(in, in) * Dot(out, out);
  return turn * turn <= TouchAngle * TouchAngle * product ? Dot(in, out) > 0.0 : turn > 0.0;
}
}

double Funnel::Run(const StripUnfolding& strip, std::vector<StripBend>& bends)
{
  const std::size_t count = strip.Portals.size();
  this->Nodes.clear();
  this->Deque.resize(2 * count + 5);
  this->First = this->Apex = this->Last = count + 2;
  this->Nodes.push_back({ { 0, StripUnfolding::Left, strip.Start }, 0 });
  this->Deque[this->Apex] = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    for (const int side : { StripUnfolding::Left, StripUnfolding::Right })
    {
      const Portal& portal = strip.Portals[i];
      if (i == 0 || portal.Vertices[side] != strip.Portals[i - 1].Vertices[side])
      {
        this->Attach(side, { i, side, portal.Ends[side] });
      }
    }
  }
  std::size_t node = this->Attach(StripUnfolding::Left, { count, StripUnfolding::Left, strip.End });
  bends.clear();
  double length = 0.0;
  while (node != 0)
  {
    const std::size_t parent = this->Nodes[node].Parent;
    length += Distance(this->Nodes[node].Bend.Position, this->Nodes[parent].Bend.Position);
    if (parent != 0)
    {
      bends.push_back(this->Nodes[parent].Bend);
    }
    node = parent;
  }
  std::reverse(bends.begin(), bends.end());
  return length;
}

/// Adds the next point on one side of the strip: the chain on that side is shortened as far as its
/// points are no longer needed. If the point lies beyond the apex, hidden by the other chain, the
/// path to it bends around that chain.
std::size_t Funnel::Attach(int side, const StripBend& point)
{
  const bool isLeft = side == StripUnfolding::Left;
  const auto inwards = [isLeft](std::size_t place) { return isLeft ? place + 1 : place - 1; };
  std::size_t& end = this->End(side);
  const std::size_t otherEnd = this->End(1 - side);
  while (end != this->Apex &&
    !BendsAround(this->Position(inwards(end)), this->Position(end), point.Position, side))
  {
    end = inwards(end);
  }
  if (end == this->Apex)
  {
    while (end != otherEnd &&
      BendsAround(this->Position(end), this->Position(inwards(end)), point.Position, 1 - side))
    {
      end = inwards(end);
    }
    this->Apex = end;
  }
  const std::size_t node = this->Nodes.size();
  this->Nodes.push_back({ point, this->Deque[end] });
  end = isLeft ? end - 1 : end + 1;
  this->Deque[end] = node;
  return node;
}
}
