// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What must hold of curves on surfaces, and of surfaces split and cut along them.
#ifndef CurveChecks_h
#define CurveChecks_h

#include "CurveInputs.h"

namespace dggtest
{
/// Everything that must hold of a curve.
void ExpectSoundCurve(const dgg::SurfaceMesh& mesh, const std::vector<dgg::SurfacePoint>& points,
  const dgg::SurfaceCurve& curve);
/// Everything that must hold of a surface refined along curves: faces cover their parents exactly,
/// edges fit, and chains lie on their curves.
void ExpectSoundEmbedding(const TestMesh& input, const dgg::SurfaceMesh& mesh,
  const std::vector<dgg::SurfaceCurve>& curves, const dgg::RefinedSurface& surface);
/// Everything that must hold of a manifold surface cut open along its paths.
void ExpectSoundCut(const dgg::RefinedSurface& surface, const dgg::CurveCut& cut);

/// Vertices that have faces minus edges plus faces, by vertex pairs.
Id EulerCharacteristic(const std::vector<Id>& triangles);
/// Loops of edges with one face, where each vertex has at most two of these.
Id CountBoundaryLoops(const std::vector<Id>& triangles);
/// Parts connected through vertices.
Id CountParts(const std::vector<Id>& triangles);
}

#endif
