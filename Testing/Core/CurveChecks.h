// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Curves on test meshes, and checks of curves and of surfaces split and cut along curves.
#ifndef CurveChecks_h
#define CurveChecks_h

#include "TestMeshes.h"

#include "dggCurveEmbedding.h"
#include "dggSurfaceCut.h"

namespace dggtest
{
/// Returns the point with these coordinates with respect to the corners of GetTriangle(), unlike
/// SurfacePoint::InFace().
dgg::SurfacePoint PointIn(
  const dgg::SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric);

/// Returns the point at the fraction `t` of the straight line between two points of a face.
dgg::SurfacePoint Between(const dgg::SurfaceMesh& mesh, const dgg::SurfacePoint& a,
  const dgg::SurfacePoint& b, Id face, double t);

/// Returns points of a random curve that runs along edges and through vertices, makes tiny or empty
/// steps, and returns to earlier points.
std::vector<dgg::SurfacePoint> RandomCurvePoints(
  const dgg::SurfaceMesh& mesh, Id count, Random& random);

/// Returns a curve; a failure fails the test.
dgg::SurfaceCurve Curve(const dgg::SurfaceMesh& mesh, const std::vector<dgg::SurfacePoint>& points,
  bool isClosed = false);
/// Returns a surface refined along curves; a failure fails the test.
dgg::SubMesh Embed(const dgg::SurfaceMesh& mesh, const std::vector<dgg::SurfaceCurve>& curves);
/// Returns the refined surface cut open along its paths.
dgg::CurveCut CutOpen(const dgg::SubMesh& surface);

/// Checks all invariants of a curve.
void ExpectSoundCurve(const dgg::SurfaceMesh& mesh, const std::vector<dgg::SurfacePoint>& points,
  const dgg::SurfaceCurve& curve);
/// Checks all invariants of a surface refined along curves: faces cover their parents exactly,
/// edges fit, and chains lie on their curves.
void ExpectSoundEmbedding(const TestMesh& input, const dgg::SurfaceMesh& mesh,
  const std::vector<dgg::SurfaceCurve>& curves, const dgg::SubMesh& surface);
/// Checks all invariants of a manifold surface cut open along its paths.
void ExpectSoundCut(const dgg::SubMesh& surface, const dgg::CurveCut& cut);
}

#endif
