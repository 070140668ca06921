// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Edges as such, of which a mesh knows half-edges only, and the neighbours along them. Internal.
#ifndef dggEdges_h
#define dggEdges_h

#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggUnfolding.h"   // for Point2

#include <algorithm> // for std::min
#include <cmath>     // for std::atan2

namespace dgg
{
/// The half-edge that represents the edge of h: the smallest one of all that lie there. `surface`
/// is a SurfaceMesh, or has half-edges as that has.
template <typename Surface>
Id FindEdge(const Surface& surface, Id h)
{
  Id smallest = h;
  for (Id e = surface.Twin(h); e != NoId && e != h; e = surface.Twin(e))
  {
    smallest = std::min(smallest, e);
  }
  return smallest;
}

/// Whether h represents its edge.
template <typename Surface>
bool RepresentsEdge(const Surface& surface, Id h)
{
  Id e = surface.Twin(h);
  while (e != NoId && e > h)
  {
    e = surface.Twin(e);
  }
  return e == NoId || e == h;
}

/// Returns the apex of the face of h in the frame of h.
inline Point2 ApexOf(const SurfaceMesh& mesh, Id h)
{
  return { mesh.ApexX(h), mesh.ApexY(h) };
}

/// Returns the polar angle at the apex of the face of h of a direction given in the frame of h.
inline double PolarAngleAtApex(const SurfaceMesh& mesh, Id h, const Point2& direction)
{
  // The reference of the corner is the edge from the apex to the origin of h.
  const Point2 reference{ -mesh.ApexX(h), -mesh.ApexY(h) };
  return mesh.PolarAngle(SurfaceMesh::Previous(h)) +
    std::atan2(Cross(reference, direction), Dot(reference, direction));
}

/// Call `visit(neighbor, length, angle)` for the edges from a vertex, once each around a regular
/// one: the vertex at the other end, the length, and the polar angle of the edge at the vertex.
template <typename Visitor>
void ForEachNeighbor(const SurfaceMesh& mesh, Id v, Visitor&& visit)
{
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    visit(mesh.Destination(*g), mesh.Length(*g), mesh.PolarAngle(*g));
    const Id incoming = SurfaceMesh::Previous(*g);
    if (mesh.Twin(incoming) == NoId)
    {
      visit(
        mesh.Origin(incoming), mesh.Length(incoming), mesh.PolarAngle(*g) + mesh.CornerAngle(*g));
    }
  }
}
}

#endif
