// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Interpolated Green's functions, corrected by distances. Internal.
#ifndef dggLocalizedGreens_h
#define dggLocalizedGreens_h

#include "dggExactGeodesics.h" // for distances
#include "dggPoissonSystem.h"  // for the matrix

#include <vector> // for the values

namespace dgg
{
/// Number of vertices around the pole whose spline weights are used: the nearest ones.
constexpr Id LocalizedVertices = 60;
/// Maximum number of these vertices and their neighbors. On ordinary meshes there are about 110;
/// many more occur where fans have hundreds of triangles.
constexpr Id MostLocalizedVertices = 400;

/// Change an interpolated Green's function around its pole x, which is not a vertex. In Green's
/// identity the numbers psi_i(x) = w_i + sum_j L_ij g_j weight the vertices i; here they are made
/// to reproduce, in the sense of least squares, the distances from vertices s around the pole,
///
///     minimise |g - g0|  subject to  sum_i d(s, i) psi_i(x) = d(s, x),
///
/// over the vertices next to those i that are near. The interpolation of g0 makes the distances
/// linear in the face of x, which they are not. `isLocalized` is false, and nothing is changed,
/// where a value nearby is given, or there are too many neighbours, or a change would be larger
/// than the values. Fails when it is stopped only.
Status Localize(const PoissonSystem& system, const SurfacePoint& pole, ExactGeodesics& exact,
  const ProgressCallback& progress, std::vector<double>& values, bool& isLocalized);
}

#endif
