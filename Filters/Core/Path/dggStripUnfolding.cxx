// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggStripUnfolding.h"

#include "dggSurfacePath.h"

#include <array>
#include <utility>

namespace dgg
{
namespace
{
/// Where a point lies in the frame of half-edge h, or, `mirrored`, in that of the same edge the
/// other way round.
Point2 Place(const SurfaceMesh& mesh, const SurfacePoint& point, Id h, bool mirrored)
{
  std::array<double, 3> barycentric{ { 1.0, 0.0, 0.0 } };
  FindInFace(mesh, point, SurfaceMesh::Face(h), barycentric);
  const Point2 p = PlaceInFrame(mesh, h, barycentric);
  return mirrored ? Point2{ mesh.Length(h) - p.X, p.Y } : p;
}
}

/// The face about to be left lies on the left of `axis`, which runs from `origin` along the edge
/// that it was entered through (half-edge h), from left to right. Directions are turned by the
/// angles of the faces: differences of points far out would lose those of tiny edges.
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
    h = SurfaceMesh::Next(h); // the first face has no edge it was entered through
    this->Start = Place(mesh, strip.Start, h, mirrored);
  }
  for (const EdgeCrossing& crossing : strip.Crossings)
  {
    const Id leftEdge = mirrored ? SurfaceMesh::Next(h) : SurfaceMesh::Previous(h);
    const Id rightEdge = mirrored ? SurfaceMesh::Previous(h) : SurfaceMesh::Next(h);
    const double x = mirrored ? mesh.Length(h) - mesh.ApexX(h) : mesh.ApexX(h);
    const FaceUnfolding face(
      mesh.Length(h), { x, mesh.ApexY(h) }, mesh.Length(leftEdge), mesh.Length(rightEdge));
    const bool isLeft = crossing.Exit == leftEdge;
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
}
