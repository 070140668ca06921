// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Smooth interpolation of values that are given at sites on a surface.
#ifndef dggBiharmonicSplines_h
#define dggBiharmonicSplines_h

#include "dggCoreExport.h"      // for DGG_CORE_EXPORT
#include "dggHarmonicSplines.h" // for Consumer
#include "dggPoissonSolver.h"   // for PoissonSolver
#include "dggSurfacePoint.h"    // for sites

#include <memory> // for the internals
#include <vector> // for values

namespace dgg
{
/// Biharmonic splines of sites x_1 ... x_k anywhere on a surface: with the Green's functions q_j of
/// the bi-Laplacian (GreensOrder::BiLaplace, linear in faces),
///
///     u = c + sum_j w_j q_j,  sum_j w_j = 0,
///
/// with a constant and a sum for each component without given values; where values are given, u is
/// 0 there, and there is neither. Of all functions with the same values at the sites u has the
/// least integral of (Laplace u)^2, in numbers u^T L M^-1 L u, as splines on a line have of u''^2.
/// Through a boundary with Neumann conditions nothing of u flows, nor of Laplace u, so that only
/// constants are reproduced: where values follow a slope, u flattens within about one distance of
/// sites from the boundary (P. Feng, J. Warren, "Discrete bi-Laplacians and biharmonic b-splines",
/// 2012, whose functions span the same space; G. Wahba, "Spline interpolation and smoothing on the
/// sphere", 1981).
class DGG_CORE_EXPORT BiharmonicSplines
{
public:
  /// The solver must be ready and outlive this.
  explicit BiharmonicSplines(const PoissonSolver& solver);
  ~BiharmonicSplines();
  BiharmonicSplines(const BiharmonicSplines&) = delete;
  BiharmonicSplines& operator=(const BiharmonicSplines&) = delete;

  /// Solve for the functions of the sites, eight at a time, and factorize a dense matrix. Fails as
  /// CheckSplinePlaces() does, and where sites are in the same place, or more than the corners of
  /// the faces that hold them, since functions are linear there: at most three in one face, two on
  /// one edge. To be done again when the solver has been prepared with other options. Progress is
  /// reported by the threads of `parallel`, several at once.
  Status Prepare(const std::vector<SurfacePoint>& sites, const ParallelFor& parallel,
    const ProgressCallback& progress);

  /// Functions per vertex, one for each column of values, one per site. They have these values to
  /// 1e-9 of their differences, mostly 1e-13, or it fails; it does where values are not finite.
  Status Interpolate(const std::vector<std::vector<double>>& siteValues,
    const ParallelFor& parallel, const ProgressCallback& progress,
    std::vector<std::vector<double>>& functions) const;

  /// The functions that are 1 at one site and 0 at the others. They sum to 1 in components without
  /// given values.
  Status FindBasis(const ParallelFor& parallel, const ProgressCallback& progress,
    const HarmonicSplines::Consumer& consume) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
