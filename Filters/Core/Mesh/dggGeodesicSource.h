// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sources of distances.
#ifndef dggGeodesicSource_h
#define dggGeodesicSource_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h"  // for SurfaceMesh
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for sources

namespace dgg
{
/// A source: a surface point and its initial distance.
struct GeodesicSource
{
  SurfacePoint Point;
  double InitialDistance = 0.0;
};

/// Fails if there is no source, or if a source does not exist on the mesh or has an initial
/// distance that is not finite. The message names the source.
DGG_CORE_EXPORT Status CheckSources(
  const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources);

/// Calls `visit(vertex, weight, distance)` for the vertices around a point. These are the vertex
/// itself for a point at a vertex, otherwise the corners of its face or of all faces of its edge.
/// The weights are the barycentric coordinates in the first of these faces (0 for other corners).
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
