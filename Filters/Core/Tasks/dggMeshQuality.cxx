// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMeshQuality.h"

#include <algorithm>

namespace dgg
{
void ReachedTriangles::Add(const SurfaceMesh& mesh, Id f, const std::vector<double>& distances)
{
  const std::array<Id, 3> corners = mesh.GetTriangle(f);
  const auto [nearest, farthest] =
    std::minmax({ distances[corners[0]], distances[corners[1]], distances[corners[2]] });
  if (mesh.IsDropped(f) || !(farthest < Infinity))
  {
    return;
  }
  this->Nearest = std::min(this->Nearest, nearest);
  this->Farthest = std::max(this->Farthest, farthest);
  const double twice = mesh.Length(3 * f) * mesh.ApexY(3 * f);
  this->Area += twice;
  this->WeightedPerimeter +=
    twice * (mesh.Length(3 * f) + mesh.Length(3 * f + 1) + mesh.Length(3 * f + 2));
}

void ReachedTriangles::Add(const ReachedTriangles& piece)
{
  this->Nearest = std::min(this->Nearest, piece.Nearest);
  this->Farthest = std::max(this->Farthest, piece.Farthest);
  this->Area += piece.Area;
  this->WeightedPerimeter += piece.WeightedPerimeter;
}

bool HasCoarseTriangles(const PreparedSurface& surface, double accuracy,
  const std::vector<double>& distances, double error)
{
  const SurfaceMesh& mesh = surface.GetMesh();
  ReachedTriangles reached;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    reached.Add(mesh, f, distances);
  }
  return HasLongTriangles(surface) || reached.AreCoarse(accuracy, error);
}
}
