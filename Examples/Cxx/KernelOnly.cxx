// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The kernel without VTK: the distance between two opposite corners of a square of two triangles.
#include "dggExactGeodesics.h"
#include "dggMeshReport.h"
#include "dggSurfaceMesh.h"

#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

int main()
{
  const std::array<double, 12> points{ { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 } };
  const std::array<dgg::Id, 6> triangles{ { 0, 1, 3, 1, 2, 3 } };
  dgg::SurfaceMesh mesh;
  dgg::Status status = dgg::SurfaceMesh::FromPoints(points.data(), 4, triangles.data(), 2, mesh);
  const std::vector<dgg::GeodesicSource> sources{ { dgg::SurfacePoint::AtVertex(0), 0.0 } };
  dgg::ExactResult result;
  if (status.IsOk())
  {
    dgg::ExactGeodesics geodesics(mesh);
    status = geodesics.Run(sources, {}, result);
  }
  if (!status.IsOk())
  {
    std::cerr << "error: " << dgg::Render(status.GetMessage()) << "\n";
    return EXIT_FAILURE;
  }
  std::cout << "boundary loops: " << dgg::InspectMesh(mesh).BoundaryLoops << "\n"
            << "distance between opposite corners: " << result.Distances[2] << "\n";
  return EXIT_SUCCESS;
}
