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
/// Least vertices around the pole whose spline weights are looked at.
constexpr Id LocalizedVertices = 60;

/// Change an interpolated Green's function around its pole x, which is not a vertex. In Green's
/// identity the numbers psi_i(x) = w_i + sum_j L_ij g_j weight the vertices i; here they are made
/// to reproduce, in the sense of least squares, the distances from vertices s around the pole,
///
///     minimise |g - g0|  subject to  sum_i d(s, i) psi_i(x) = d(s, x),
///
/// over the vertices next to those i that are near. The interpolation of g0 makes the distances
/// linear in the face of x, which they are not. False, and nothing is changed, where a value nearby
/// is given, or a change would be larger than the values.
bool Localize(const PoissonSystem& system, const SurfacePoint& pole, ExactGeodesics& exact,
  std::vector<double>& values);
}

#endif
