// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsRefinement.h"

#include "dggFaceRefinement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace dgg
{
namespace
{
/// Returns the faces with a vertex on a path.
std::vector<Id> FindFacesAroundCurves(const SubMesh& surface)
{
  std::vector<char> isTouched(surface.Points.size(), 0);
  for (const std::vector<Id>& path : surface.Paths)
  {
    for (const Id v : path)
    {
      isTouched[v] = 1;
    }
  }
  std::vector<Id> faces;
  for (Id f = 0; f < surface.GetNumberOfFaces(); ++f)
  {
    const Id* corners = surface.Triangles.data() + 3 * f;
    if (isTouched[corners[0]] || isTouched[corners[1]] || isTouched[corners[2]])
    {
      faces.push_back(f);
    }
  }
  return faces;
}

std::vector<Id> ChooseFaces(const GraphicsRefinement& refinement, const SubMesh& surface)
{
  if (refinement.Part == RefinedPart::AroundCurves)
  {
    return FindFacesAroundCurves(surface);
  }
  std::vector<Id> meant = refinement.Faces;
  std::sort(meant.begin(), meant.end());
  std::vector<Id> faces;
  for (std::size_t f = 0; f < surface.Faces.size(); ++f)
  {
    if (refinement.Part == RefinedPart::Everything ||
      std::binary_search(meant.begin(), meant.end(), surface.Faces[f]))
    {
      faces.push_back(static_cast<Id>(f));
    }
  }
  return faces;
}

/// Finds the faces whose parents are among the given ones, which must be sorted.
void FindParts(const std::vector<Id>& faces, const std::vector<Id>& parents, std::vector<Id>& parts)
{
  parts.clear();
  for (std::size_t f = 0; f < parents.size(); ++f)
  {
    if (std::binary_search(faces.begin(), faces.end(), parents[f]))
    {
      parts.push_back(static_cast<Id>(f));
    }
  }
}
}

Status RefineForGraphics(const SurfaceMesh& mesh, const GraphicsRefinement& refinement,
  SubMesh& surface, std::vector<Id>* parts)
{
  const std::vector<Id> faces = ChooseFaces(refinement, surface);
  const double partsPerFace = std::pow(4.0, refinement.Levels);
  const double count = static_cast<double>(surface.Faces.size()) +
    (partsPerFace - 1.0) * static_cast<double>(faces.size());
  if (count > static_cast<double>(refinement.MostFaces))
  {
    return Status(Status::Code::OutOfMemory,
      JoinText("Refinement needs at least ", static_cast<Offset>(std::min(count, 1e18)),
        " faces, more than the limit of ", refinement.MostFaces));
  }
  std::vector<Id> parents;
  Status status = RefineFaces(mesh, faces, refinement.Levels, refinement.Progress, surface, parents,
    refinement.MostFaces); // including additional rings
  if (status.IsOk() && parts)
  {
    FindParts(faces, parents, *parts);
  }
  return status;
}
}
