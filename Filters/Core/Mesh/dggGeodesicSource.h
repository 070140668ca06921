// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where distances are measured from.
#ifndef dggGeodesicSource_h
#define dggGeodesicSource_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h"  // for SurfaceMesh
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for sources

namespace dgg
{
/// A source of distance: a point of the surface and the distance that it starts with.
struct GeodesicSource
{
  SurfacePoint Point;
  double InitialDistance = 0.0;
};

/// Fails when there is no source, or one does not exist on the mesh or starts with a distance that
/// is not finite. The message names it.
DGG_CORE_EXPORT Status CheckSources(
  const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources);

/// Call `visit(vertex, weight, distance)` for the vertices that a point is seen from within its
/// faces: itself when it is a vertex, else the corners of its face or of the faces around its edge,
/// with its barycentric coordinates as weights in the first of these faces (0 in the others).
template <typename Visitor>
void ForEachCornerAround(const SurfaceMesh& mesh, const SurfacePoint& point, Visitor&& visit)
{
  if (point.On == SurfacePoint::Support::Vertex)
  {
    visit(point.Vertex, 1.0, 0.0);
    return;
  }
  bool isFirst = true;
  ForEachFaceAround(mesh, point, [&](Id f, const std::array<double, 3>& b) {
    for (int k = 0; k < 3; ++k)
    {
      visit(mesh.Origin(3 * f + k), isFirst ? b[k] : 0.0, DistanceToCorner(mesh, f, b, k));
    }
    isFirst = false;
  });
}
}

#endif
