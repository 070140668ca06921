// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeGraph.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace dggtest
{
std::vector<double> EdgeGraphDistances(
  const dgg::SurfaceMesh& mesh, const std::vector<dgg::GeodesicSource>& sources)
{
  std::vector<double> distances(mesh.GetNumberOfVertices(), dgg::Infinity);
  using Entry = std::pair<double, dgg::Id>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  auto lower = [&](dgg::Id v, double distance) {
    if (distance < distances[v])
    {
      distances[v] = distance;
      queue.emplace(distance, v);
    }
  };
  for (const dgg::GeodesicSource& source : sources)
  {
    const dgg::SurfacePoint& point = source.Point;
    if (!point.Check(mesh).IsOk())
    {
      continue;
    }
    if (point.On == dgg::SurfacePoint::Support::Vertex)
    {
      lower(point.Vertex, source.InitialDistance);
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      lower(mesh.Origin(3 * point.Face + k),
        source.InitialDistance + dgg::DistanceToCorner(mesh, point.Face, point.Barycentric, k));
    }
  }
  while (!queue.empty())
  {
    const Entry top = queue.top();
    queue.pop();
    if (top.first > distances[top.second])
    {
      continue;
    }
    for (const dgg::Id* g = mesh.FanBegin(top.second); g != mesh.FanEnd(top.second); ++g)
    {
      const dgg::Id incoming = dgg::SurfaceMesh::Previous(*g);
      lower(mesh.Destination(*g), top.first + mesh.Length(*g));
      lower(mesh.Origin(incoming), top.first + mesh.Length(incoming));
    }
  }
  return distances;
}
}
