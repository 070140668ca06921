// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggExactSources.h"

#include "dggCornerModel.h"

#include <algorithm>
#include <cmath>
#include <utility>
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

/// How far a model is from the distances of the neighbours, on the whole.
double Misfit(const SurfaceMesh& mesh, Id v, const CornerModel& model, const ExactResult& result)
{
  double misfit = 0.0;
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    const double d = result.Distances[mesh.Destination(*g)];
    if (d < Infinity)
    {
      misfit += std::abs(model.At(mesh.Length(*g), mesh.PolarAngle(*g)) - d);
    }
  }
  return misfit;
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
  // Those that are reached, which may be few, the nearest first.
  std::vector<std::pair<double, Id>> order;
  order.reserve(static_cast<std::size_t>(std::count_if(
    result.Distances.begin(), result.Distances.end(), [](double d) { return d < Infinity; })));
  for (std::size_t v = 0; v < n; ++v)
  {
    if (result.Distances[v] < Infinity)
    {
      order.emplace_back(result.Distances[v], static_cast<Id>(v));
    }
  }
  std::sort(order.begin(), order.end());
  for (const auto& [d, v] : order)
  {
    const Predecessor& p = result.Predecessors[v];
    LastPiece piece = FindLastPiece(mesh, sources, v, p);
    // Behind a vertex that the way only passes by, it is the same light as before.
    if (p.Root >= 0 && p.Root != v && found.Lengths[p.Root] > 0.0)
    {
      const double longer = piece.Length + found.Lengths[p.Root];
      const CornerModel here(mesh, v, d - piece.Length, piece.Length, piece.Angle);
      const CornerModel before(mesh, v, d - longer, longer, piece.Angle);
      if (here.IsKnown && Misfit(mesh, v, before, result) < Misfit(mesh, v, here, result))
      {
        piece.Length = longer;
      }
    }
    found.Offsets[v] = d - piece.Length;
    found.Lengths[v] = piece.Length;
    found.Angles[v] = piece.Angle;
  }
}
}
