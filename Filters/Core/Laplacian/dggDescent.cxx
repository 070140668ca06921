// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggDescent.h"

#include "dggDistanceHeap.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
template <typename Visitor>
void ForEachNeighbour(const SurfaceMesh& mesh, Id v, Visitor&& visit)
{
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    const Id incoming = SurfaceMesh::Previous(*g);
    visit(mesh.Destination(*g), mesh.Length(*g));
    visit(mesh.Origin(incoming), mesh.Length(incoming));
  }
}

/// The direction from the origin of half-edge h to the source, in the frame of h; false when the
/// distances do not tell.
bool PointToSource(const SurfaceMesh& mesh, Id h, double offset,
  const std::vector<double>& distances, Point2& direction)
{
  const double length = mesh.Length(h);
  const double x = mesh.ApexX(h);
  const double y = mesh.ApexY(h);
  const double a = distances[mesh.Origin(h)] - offset;
  const double b = distances[mesh.Destination(h)] - offset;
  const double c = distances[mesh.Apex(h)] - offset;
  // |p|^2 - d(p)^2 is linear in the plane; its gradient is twice the place of the source.
  direction.X = 0.5 * (length + (a - b) * (a + b) / length);
  direction.Y = 0.5 * ((x * x + y * y + (a - c) * (a + c)) - 2.0 * x * direction.X) / y;
  const double norm = Norm(direction.X, direction.Y);
  if (!(norm > 0.0) || !std::isfinite(norm))
  {
    return false;
  }
  direction.X /= norm;
  direction.Y /= norm;
  return true;
}
}

std::vector<Id> FindNearestByDescent(const SurfaceMesh& mesh, const std::vector<double>& distances,
  const std::vector<DescentSeed>& seeds)
{
  std::vector<Id> nearest(distances.size(), NoId);
  std::vector<double> best(distances.size(), Infinity); // of seeds
  std::vector<std::uint8_t> isDone(distances.size(), 0);
  std::vector<std::uint8_t> isPushed(distances.size(), 0);
  DistanceHeap heap;
  for (const DescentSeed& seed : seeds)
  {
    if (seed.Distance < best[seed.Vertex])
    {
      best[seed.Vertex] = seed.Distance;
      nearest[seed.Vertex] = seed.Source;
    }
    if (!isPushed[seed.Vertex])
    {
      isPushed[seed.Vertex] = 1;
      heap.Push(distances[seed.Vertex], seed.Vertex);
    }
  }
  while (!heap.IsEmpty())
  {
    const DistanceHeap::Key top = heap.Pop();
    const Id v = top.Index;
    // A seed keeps its source unless the field passes below it.
    double steepest = distances[v] < best[v] ? -Infinity : Infinity;
    ForEachNeighbour(mesh, v, [&](Id u, double length) {
      if (isDone[u] && (distances[v] - distances[u]) > steepest * length)
      {
        steepest = (distances[v] - distances[u]) / std::max(length, 1e-300);
        nearest[v] = nearest[u];
      }
    });
    isDone[v] = 1;
    ForEachNeighbour(mesh, v, [&](Id u, double) {
      if (!isPushed[u] && distances[u] < Infinity)
      {
        isPushed[u] = 1;
        heap.Push(std::max(top.Distance, distances[u]), u);
      }
    });
  }
  return nearest;
}

std::vector<double> FindDirectionsOfDescent(
  const SurfaceMesh& mesh, const std::vector<double>& distances, const std::vector<double>& offsets)
{
  std::vector<double> angles(distances.size(), 0.0);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (!(distances[v] < Infinity))
    {
      continue;
    }
    const VertexKind kind = mesh.Kind(v);
    const bool isClosed = kind != VertexKind::Boundary && kind != VertexKind::Irregular;
    const double scale = isClosed ? 2.0 * Pi / mesh.TotalAngle(v) : 1.0;
    Point2 sum;
    double best = Infinity;
    for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
    {
      Point2 direction;
      if (!PointToSource(mesh, *g, offsets[v], distances, direction))
      {
        continue;
      }
      const double corner = mesh.CornerAngle(*g);
      const double begin = mesh.PolarAngle(*g);
      const double turn = std::atan2(direction.Y, direction.X);
      if (kind == VertexKind::Irregular)
      {
        const double inside = std::min(std::max(turn, 0.0), corner);
        const double off = std::min(std::abs(turn - inside), std::abs(turn + 2.0 * Pi - inside));
        if (off < best)
        {
          best = off;
          angles[v] = begin + inside;
        }
        continue;
      }
      // Scaled around the middle of the corner: what is outside of it is not of this face.
      const double angle = scale * (begin + 0.5 * corner) + (turn - 0.5 * corner);
      sum.X += corner * std::cos(angle);
      sum.Y += corner * std::sin(angle);
    }
    if (kind != VertexKind::Irregular && (sum.X != 0.0 || sum.Y != 0.0))
    {
      const double total = mesh.TotalAngle(v);
      double angle = std::atan2(sum.Y, sum.X);
      if (isClosed)
      {
        angles[v] = (angle < 0.0 ? angle + 2.0 * Pi : angle) / scale;
        continue;
      }
      // Into the surface: the nearer of its two ends when it points outside.
      const double middle = 0.5 * total;
      angle += 2.0 * Pi * std::round((middle - angle) / (2.0 * Pi));
      angles[v] = std::min(std::max(angle, 0.0), total);
    }
  }
  return angles;
}
}
