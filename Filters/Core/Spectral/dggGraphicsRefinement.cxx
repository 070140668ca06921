// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsRefinement.h"

#include "dggFaceSubdivision.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dgg
{
namespace
{
using Flags = std::vector<std::uint8_t>;

/// The faces with a vertex that is meant.
Flags FindFacesAt(const RefinedSurface& surface, const Flags& isMeant)
{
  Flags faces(surface.Faces.size(), 0);
  for (std::size_t h = 0; h < surface.Triangles.size(); ++h)
  {
    faces[h / 3] = faces[h / 3] | isMeant[surface.Triangles[h]];
  }
  return faces;
}

Flags FindFacesAroundCurves(const RefinedSurface& surface, int rings)
{
  Flags vertices(surface.Points.size(), 0);
  for (const std::vector<Id>& path : surface.Paths)
  {
    for (const Id v : path)
    {
      vertices[v] = 1;
    }
  }
  Flags faces = FindFacesAt(surface, vertices);
  for (int ring = 0; ring < rings; ++ring)
  {
    for (std::size_t h = 0; h < surface.Triangles.size(); ++h)
    {
      vertices[surface.Triangles[h]] = vertices[surface.Triangles[h]] | faces[h / 3];
    }
    faces = FindFacesAt(surface, vertices);
  }
  return faces;
}

/// Those at the ends of curves of one edge.
Flags FindFacesAtSingleEdges(const RefinedSurface& surface)
{
  Flags vertices(surface.Points.size(), 0);
  for (const std::vector<Id>& path : surface.Paths)
  {
    if (path.size() == 2)
    {
      vertices[path[0]] = 1;
      vertices[path[1]] = 1;
    }
  }
  return FindFacesAt(surface, vertices);
}

bool IsAny(const Flags& flags)
{
  return std::find(flags.begin(), flags.end(), 1) != flags.end();
}
}

Status RefineForGraphics(
  const SurfaceMesh& mesh, const GraphicsRefinement& refinement, RefinedSurface& surface)
{
  Status status;
  const Flags singles = FindFacesAtSingleEdges(surface);
  if (IsAny(singles))
  {
    status = SubdivideFaces(mesh, singles, refinement.MostFaces, surface);
  }
  for (int level = 0; level < refinement.Levels && status.IsOk(); ++level)
  {
    if (refinement.Progress && !refinement.Progress(static_cast<double>(level) / refinement.Levels))
    {
      return Status::Abort();
    }
    const Flags faces = refinement.IsEverywhere ? Flags(surface.Faces.size(), 1)
                                                : FindFacesAroundCurves(surface, refinement.Rings);
    status = SubdivideFaces(mesh, faces, refinement.MostFaces, surface);
  }
  return status;
}
}
