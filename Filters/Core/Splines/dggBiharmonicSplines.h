// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Smooth interpolation of values at sites on a surface.
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
/// with one constant and one side condition per component without given values. In components with
/// given values there is neither, and u is 0 at given values. Among all functions with the same
/// values at the sites, u minimizes the integral of (Laplace u)^2, discretely u^T L M^-1 L u, as
/// cubic splines on a line minimize the integral of u''^2. With Neumann conditions, neither u nor
/// Laplace u has flux through the boundary, so that only constants are reproduced: where values
/// follow a slope, u flattens within about one site spacing from the boundary (P. Feng, J. Warren,
/// "Discrete bi-Laplacians and biharmonic b-splines", 2012, whose functions span the same space; G.
/// Wahba, "Spline interpolation and smoothing on the sphere", 1981).
class DGG_CORE_EXPORT BiharmonicSplines
{
public:
  /// The solver must be ready and outlive the object.
  explicit BiharmonicSplines(const PoissonSolver& solver);
  ~BiharmonicSplines();
  BiharmonicSplines(const BiharmonicSplines&) = delete;
  BiharmonicSplines& operator=(const BiharmonicSplines&) = delete;

  /// Solves for the functions of the sites, eight at a time, and factorizes a dense matrix. Fails
  /// like CheckSplinePlaces(), if sites coincide, or if a face contains too many sites, since
  /// functions are linear in faces: at most three in one face, two on one edge. Must be repeated
  /// after the solver has been prepared with other options. Progress is reported by the threads of
  /// `parallel`, several simultaneously.
  Status Prepare(const std::vector<SurfacePoint>& sites, const ParallelFor& parallel,
    const ProgressCallback& progress);

  /// Computes functions per vertex, one for each column of values, one value per site. They
  /// interpolate the values to 1e-9 of their range (1e-13 usually), otherwise the call fails; it
  /// also fails if values are not finite.
  Status Interpolate(const std::vector<std::vector<double>>& siteValues,
    const ParallelFor& parallel, const ProgressCallback& progress,
    std::vector<std::vector<double>>& functions) const;

  /// Computes the functions that are 1 at one site and 0 at the others. They sum to 1 in components
  /// without given values.
  Status FindBasis(const ParallelFor& parallel, const ProgressCallback& progress,
    const HarmonicSplines::Consumer& consume) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
