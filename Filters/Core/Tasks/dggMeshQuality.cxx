// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMeshQuality.h"

#include <algorithm>

namespace dgg
{
bool HasCoarseTriangles(const PreparedSurface& surface, double accuracy,
  const std::vector<double>& distances, double error)
{
  const SurfaceMesh& mesh = surface.GetMesh();
  double least = Infinity;
  double largest = 0.0;
  double area = 0.0;
  double weighted = 0.0; // perimeters times areas
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    const std::array<Id, 3> corners = mesh.GetTriangle(f);
    const auto [nearest, farthest] =
      std::minmax({ distances[corners[0]], distances[corners[1]], distances[corners[2]] });
    if (mesh.IsDropped(f) || !(farthest < Infinity))
    {
      continue;
    }
    least = std::min(least, nearest);
    largest = std::max(largest, farthest);
    const double twice = mesh.Length(3 * f) * mesh.ApexY(3 * f);
    area += twice;
    weighted += twice * (mesh.Length(3 * f) + mesh.Length(3 * f + 1) + mesh.Length(3 * f + 2));
  }
  return HasLongTriangles(surface) ||
    (area > 0.0 && accuracy * (largest - least) * area < error * weighted / 3.0);
}
}
