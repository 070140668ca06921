// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tools shared by the tests of paths, loops and curves.
#ifndef PathChecks_h
#define PathChecks_h

#include "TestMeshes.h"

#include "dggSurfacePath.h"

namespace dggtest
{
std::vector<dgg::SurfacePoint> AtVertices(const std::vector<Id>& vertices);
/// Returns random points in faces, followed by random vertices.
std::vector<dgg::SurfacePoint> SomePoints(
  const dgg::SurfaceMesh& mesh, Id inFaces, Id atVertices, std::uint64_t seed);
/// Returns the point of a planar mesh at a position in the plane.
dgg::SurfacePoint PointInPlane(
  const TestMesh& points, const dgg::SurfaceMesh& mesh, double x, double y);

/// Returns exact shortest paths; a failure fails the test.
std::vector<dgg::SurfacePath> FindPaths(const dgg::SurfaceMesh& mesh, const dgg::SurfacePoint& from,
  const std::vector<dgg::SurfacePoint>& to);
dgg::SurfacePath PathBetween(const dgg::SurfaceMesh& mesh, Id from, Id to);
/// Appends a path that starts at the end of `path`.
void AppendPath(const dgg::SurfacePath& more, dgg::SurfacePath& path);

/// Expects a geodesic to be locally shortest at each of its points. The two ends are skipped unless
/// the path is closed and `isSmoothAtStart`.
void ExpectLocallyShortest(
  const dgg::SurfaceMesh& mesh, const dgg::SurfacePath& path, bool isSmoothAtStart = false);
}

#endif
