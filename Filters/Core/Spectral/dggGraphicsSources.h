// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sources of colour in regions and along curves. Internal.
#ifndef dggGraphicsSources_h
#define dggGraphicsSources_h

#include "dggGraphicsDomain.h" // for the surface

#include <vector> // for loads

namespace dgg
{
/// The faces on the left of a closed curve. Fails when the curve is open, has no sides, or one can
/// walk from its left to its right.
Status FindFacesOnLeft(
  const RefinedSurface& surface, const CurveChain& chain, bool isClosed, std::vector<Id>& faces);

/// Add the integrals of the sources of a region against hat functions, see GraphicsRegion. Faces
/// are those of the surface. Nothing is added when they have no area. Loads are those of vertices,
/// one array per channel; they sum to 0 to rounding where there is a rim.
void AddRegion(const SurfaceMesh& mesh, const CutSurface& surface, const std::vector<Id>& faces,
  const std::vector<double>& strength, std::vector<std::vector<double>>& loads);

/// The lengths of the edges of a chain.
std::vector<double> MeasureChain(const RefinedSurface& surface, const CurveChain& chain);

/// Add the integrals of a flow per length along a curve, linear in between, against hat functions.
/// `lengths` are those of MeasureChain().
void AddLineSource(const CurveChain& chain, const std::vector<double>& lengths,
  const GraphicsCurve& curve, std::vector<std::vector<double>>& loads);
}

#endif
