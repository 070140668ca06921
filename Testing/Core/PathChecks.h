// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tools shared by the tests of paths, loops and curves.
#ifndef PathChecks_h
#define PathChecks_h

#include "TestMeshes.h"

#include "dggSurfacePath.h"

#include <vector>

namespace dggtest
{
std::vector<dgg::SurfacePoint> AtVertices(const std::vector<Id>& vertices);
/// Random points in faces, and after them random vertices.
std::vector<dgg::SurfacePoint> SomePoints(
  const dgg::SurfaceMesh& mesh, Id inFaces, Id atVertices, std::uint64_t seed);
/// A place in the plane as a point of a plane mesh.
dgg::SurfacePoint PointInPlane(
  const TestMesh& points, const dgg::SurfaceMesh& mesh, double x, double y);

/// Exact shortest paths; a failure fails the test.
std::vector<dgg::SurfacePath> FindPaths(const dgg::SurfaceMesh& mesh, const dgg::SurfacePoint& from,
  const std::vector<dgg::SurfacePoint>& to);
dgg::SurfacePath PathBetween(const dgg::SurfaceMesh& mesh, Id from, Id to);
/// Make a path go on along another one, which starts where it ends.
void AppendPath(const dgg::SurfacePath& more, dgg::SurfacePath& path);

/// Around each of its points a geodesic is the shortest way. The two ends are not looked at, unless
/// the path is closed and `isSmoothAtStart`.
void ExpectLocallyShortest(
  const dgg::SurfaceMesh& mesh, const dgg::SurfacePath& path, bool isSmoothAtStart = false);
}

#endif
