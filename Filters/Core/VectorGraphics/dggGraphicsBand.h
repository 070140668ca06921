// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a Poisson curve adds to the colours around it. Internal.
#ifndef dggGraphicsBand_h
#define dggGraphicsBand_h

#include "dggExactGeodesics.h" // for distances
#include "dggGraphicsDomain.h" // for sides

#include <vector> // for values

namespace dgg
{
/// Whether strengths change along a curve, and so are blended in its band, for which equations are
/// solved.
bool IsBlended(const GraphicsCurve& curve, int channels);

/// Add B, see VectorGraphics, of one curve with sides on a mesh to values per vertex, all channels
/// of one after each other. The distances of points from a side are those from its vertices and
/// three points in between on each edge, of length L. At the curve, a distance is up to L/8 too
/// long; since b is flat there, that costs up to 2 (L/8w)^2 of the colour: 3.5e-3 for a width w of
/// three edges, and a quarter as much for each level of refinement.
///
/// Where strengths change along the curve, they are blended: each is harmonic in the band.
Status AddBand(const SurfaceMesh& mesh, const CurveSides& sides, const CurveChain& chain,
  const GraphicsCurve& curve, int channels, ExactGeodesics& exact, const ProgressCallback& progress,
  std::vector<double>& values);
}

#endif
