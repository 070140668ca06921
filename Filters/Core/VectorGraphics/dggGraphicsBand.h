// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Color contribution of a Poisson curve. Internal.
#ifndef dggGraphicsBand_h
#define dggGraphicsBand_h

#include "dggExactGeodesics.h" // for distances
#include "dggGraphicsDomain.h" // for sides

#include <vector> // for values

namespace dgg
{
/// Returns true if strengths vary along a curve, so that they are blended in its band by solving
/// equations.
bool IsBlended(const GraphicsCurve& curve, int channels);

/// Adds the function B (see VectorGraphics) of one curve with sides to values per vertex, all
/// channels of a vertex consecutively. The distances of points from a side are those from its
/// vertices and from three points in between on each edge of length L. At the curve, such a
/// distance is up to L/8 too long; since b is flat there, the color error is at most 2 (L/8w)^2:
/// 3.5e-3 for a width w of three edges, and a quarter of that for each level of refinement.
///
/// Strengths that vary along the curve are blended: each is harmonic in the band.
///
/// `contrast` is the part, at most 1, of the difference between the two sides that remains where
/// an open curve shorter than twice its width separates them best: a point on one side is at most
/// as far from the other side as from an end. It is 1 for other curves.
Status AddBand(const SurfaceMesh& mesh, const CurveSides& sides, const CurveChain& chain,
  const GraphicsCurve& curve, int channels, ExactGeodesics& exact, const ProgressCallback& progress,
  std::vector<double>& values, double& contrast);
}

#endif
