// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMeshQuality.h"

#include "dggCounted.h"
#include "dggSurfaceOutput.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace dgg
{
namespace
{
/// Number of triangles that a warning names.
constexpr std::size_t NamedCells = 3;

double GetPerimeter(const SurfaceMesh& mesh, Id f)
{
  return mesh.Length(3 * f) + mesh.Length(3 * f + 1) + mesh.Length(3 * f + 2);
}

/// Returns the largest distance of a corner.
double FindFarthest(const SurfaceMesh& mesh, Id f, const std::vector<double>& distances)
{
  const std::array<Id, 3> corners = mesh.GetTriangle(f);
  return std::max({ distances[corners[0]], distances[corners[1]], distances[corners[2]] });
}
}

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
  this->WeightedPerimeter += twice * GetPerimeter(mesh, f);
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

std::string DescribeMissingWindows(const PreparedSurface& surface, double accuracy,
  const std::vector<double>& distances, double error, const Status& status)
{
  const SurfaceMesh& mesh = surface.GetMesh();
  std::vector<Id> coarse;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    const double farthest = distances.empty() ? 0.0 : FindFarthest(mesh, f, distances);
    if (!mesh.IsDropped(f) && accuracy * farthest < error * GetPerimeter(mesh, f) / 3.0)
    {
      coarse.push_back(f);
    }
  }
  std::sort(coarse.begin(), coarse.end(), [&](Id f, Id g) {
    return std::make_pair(-GetPerimeter(mesh, f), f) < std::make_pair(-GetPerimeter(mesh, g), g);
  });
  std::string places = coarse.empty() ? "triangles" : Counted(coarse.size(), "triangle");
  std::vector<Offset> cells; // a cell may have several triangles
  for (std::size_t i = 0; i < coarse.size() && cells.size() < NamedCells; ++i)
  {
    const Offset cell = GetOriginalCell(surface, coarse[i]);
    if (std::find(cells.begin(), cells.end(), cell) == cells.end())
    {
      places += JoinText(cells.empty() ? " (largest cells: " : ", ", cell);
      cells.push_back(cell);
    }
  }
  places += cells.empty() ? "" : ")";
  const bool isOutOfMemory = status.GetCode() == Status::Code::OutOfMemory;
  return JoinText(isOutOfMemory ? "Windows need more than {MemoryLimit}" : "Windows were not found",
    ", so errors may exceed the accuracy of the graph inside ", places, ". ",
    isOutOfMemory ? "Increase {MemoryLimit} or remesh the surface" : "Remesh the surface");
}
}
