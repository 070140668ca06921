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
/// Number of vertices around the pole, the nearest ones, whose spline weights are used.
constexpr Id LocalizedVertices = 60;
/// Maximum number of these vertices and their neighbors. The usual number is about 110; larger
/// numbers occur if fans have hundreds of triangles.
constexpr Id MostLocalizedVertices = 400;

/// Modifies an interpolated Green's function around its pole x, which is not a vertex. In Green's
/// identity the vertices i have the weights psi_i(x) = w_i + sum_j L_ij g_j. The values are changed
/// so that these weights reproduce, in the least-squares sense, the distances from vertices s
/// around the pole,
///
///     minimize |g - g0|  subject to  sum_i d(s, i) psi_i(x) = d(s, x),
///
/// over the neighbors of the near vertices i. The interpolation of g0 makes the distances linear in
/// the face of x, although exact distances are not linear. `isLocalized` is false, and the values
/// are unchanged, if a nearby value is given, the number of neighbors is too large, or a change
/// would be larger than the values. Only fails when stopped.
Status Localize(const PoissonSystem& system, const SurfacePoint& pole, ExactGeodesics& exact,
  const ProgressCallback& progress, std::vector<double>& values, bool& isLocalized);
}

#endif
