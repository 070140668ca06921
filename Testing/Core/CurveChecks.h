// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Curves on test meshes; what must hold of them, and of surfaces split and cut along them.
#ifndef CurveChecks_h
#define CurveChecks_h

#include "TestMeshes.h"

#include "dggSurfaceCut.h"
#include "dggCurveEmbedding.h"

namespace dggtest
{
/// Coordinates with respect to the corners of GetTriangle(), unlike SurfacePoint::InFace().
dgg::SurfacePoint PointIn(
  const dgg::SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric);

/// The point on the straight line between two points of a face, `t` of the way.
dgg::SurfacePoint Between(const dgg::SurfaceMesh& mesh, const dgg::SurfacePoint& a,
  const dgg::SurfacePoint& b, Id face, double t);

/// Points of a curve that does whatever curves may do: it runs along edges and through vertices,
/// makes tiny steps, stays where it is, and comes back to points that it has been at.
std::vector<dgg::SurfacePoint> RandomCurvePoints(
  const dgg::SurfaceMesh& mesh, Id count, Random& random);

/// A curve, which must be possible.
dgg::SurfaceCurve Curve(const dgg::SurfaceMesh& mesh, const std::vector<dgg::SurfacePoint>& points,
  bool isClosed = false);
/// A surface refined along curves, which must be possible.
dgg::SubMesh Embed(const dgg::SurfaceMesh& mesh, const std::vector<dgg::SurfaceCurve>& curves);
/// The same cut open.
dgg::CurveCut CutOpen(const dgg::SubMesh& surface);

/// Everything that must hold of a curve.
void ExpectSoundCurve(const dgg::SurfaceMesh& mesh, const std::vector<dgg::SurfacePoint>& points,
  const dgg::SurfaceCurve& curve);
/// Everything that must hold of a surface refined along curves: faces cover their parents exactly,
/// edges fit, and chains lie on their curves.
void ExpectSoundEmbedding(const TestMesh& input, const dgg::SurfaceMesh& mesh,
  const std::vector<dgg::SurfaceCurve>& curves, const dgg::SubMesh& surface);
/// Everything that must hold of a manifold surface cut open along its paths.
void ExpectSoundCut(const dgg::SubMesh& surface, const dgg::CurveCut& cut);
}

#endif
