// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggExactSources.h"

#include "dggRelays.h"

#include <cmath>
#include <vector>

namespace dgg
{
namespace
{
/// The last straight piece of the way to a vertex, as the vertex sees it.
struct LastPiece
{
  double Length = 0.0;
  double Angle = 0.0;
};

/// Through the face of a half-edge, whose apex the vertex is.
LastPiece ThroughFace(const SurfaceMesh& mesh, const Predecessor& p)
{
  const Point2 apex{ mesh.ApexX(p.HalfEdge), mesh.ApexY(p.HalfEdge) };
  const Point2 back{ p.ImageX - apex.X, p.ImageY - apex.Y };
  // The reference of the corner is the edge from the apex to the origin of the half-edge.
  const double angle =
    std::atan2(-apex.X * back.Y + apex.Y * back.X, -apex.X * back.X - apex.Y * back.Y);
  return { Norm(back.X, back.Y), mesh.PolarAngle(SurfaceMesh::Previous(p.HalfEdge)) + angle };
}

/// Along the shortest edge between the two vertices.
LastPiece AlongEdge(const SurfaceMesh& mesh, Id v, Id root)
{
  LastPiece piece{ Infinity, 0.0 };
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    const Id incoming = SurfaceMesh::Previous(*g);
    if (mesh.Destination(*g) == root && mesh.Length(*g) < piece.Length)
    {
      piece = { mesh.Length(*g), mesh.PolarAngle(*g) };
    }
    else if (mesh.Twin(incoming) == NoId && mesh.Origin(incoming) == root &&
      mesh.Length(incoming) < piece.Length)
    {
      piece = { mesh.Length(incoming), mesh.PolarAngle(*g) + mesh.CornerAngle(*g) };
    }
  }
  return piece;
}

/// Within a face that the source lies in.
LastPiece WithinFace(const SurfaceMesh& mesh, Id v, const SurfacePoint& source)
{
  LastPiece piece{ Infinity, 0.0 };
  ForEachFaceAround(mesh, source, [&](Id f, const std::array<double, 3>& b) {
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Point2 p = PlaceInFrame(mesh, h, b);
      const double length = Norm(p.X, p.Y);
      if (mesh.Origin(h) == v && length < piece.Length)
      {
        piece = { length, mesh.PolarAngle(h) + std::atan2(p.Y, p.X) };
      }
    }
  });
  return piece;
}

LastPiece FindLastPiece(
  const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources, Id v, const Predecessor& p)
{
  if (p.Root == v)
  {
    return {};
  }
  if (p.HalfEdge != NoId)
  {
    return ThroughFace(mesh, p);
  }
  return p.Root >= 0 ? AlongEdge(mesh, v, p.Root) : WithinFace(mesh, v, sources[~p.Root].Point);
}
}

void FindVirtualSources(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const ExactResult& result, VirtualSources& found)
{
  const std::size_t n = result.Distances.size();
  found.Offsets.assign(n, Infinity);
  found.Lengths.assign(n, Infinity);
  found.Angles.assign(n, 0.0);
  std::vector<Id> relays(n, NoId);
  const std::vector<Id> order = SortReached(result.Distances);
  for (const Id v : order)
  {
    const Predecessor& p = result.Predecessors[v];
    const LastPiece piece = FindLastPiece(mesh, sources, v, p);
    relays[v] = p.Root >= 0 && p.Root != v ? p.Root : NoId;
    found.Offsets[v] = result.Distances[v] - piece.Length;
    found.Lengths[v] = piece.Length;
    found.Angles[v] = piece.Angle;
  }
  MergeRelays(mesh, result.Distances, order, relays, found);
}
}
