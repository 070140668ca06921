// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Harmonic B-splines on a surface.
#ifndef dggHarmonicSplines_h
#define dggHarmonicSplines_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggGreensFunction.h" // for methods
#include "dggParallel.h"       // for ParallelFor
#include "dggPoissonSolver.h"  // for PoissonSolver
#include "dggSurfacePoint.h"   // for points

#include <functional> // for Consumer
#include <memory>     // for the internals
#include <vector>     // for sites and values

namespace dgg
{
/// Harmonic B-splines of sites V_1 ... V_k, which are vertices (Feng and Warren, "Discrete
/// bi-Laplacians and biharmonic b-splines", 2012; for one harmonic order and on surfaces Z. Fang,
/// "Discrete Geodesic Graphs", thesis, 2019, chapter 4). The geodesic Voronoi diagram of the sites
/// partitions the vertices into cells. With cell areas A_j, the total area A of the component, g
/// the Green's function, gbar_j its mean over cell j, and c_ij = length of the border between two
/// cells / distance of their sites, the basis function of site j is
///
///     psi_j(x) = A_j / A + sum_i c_ij (gbar_j(x) - gbar_i(x)),
///
/// with g positive at its pole (in the thesis g is negative and the difference reversed). -Laplace
/// psi_j is constant in each cell. The psi_j sum to 1 and have the mean A_j / A. Like other
/// B-splines they do not interpolate: on the unit sphere with 40 sites psi_j is 0.57 to 0.70 at its
/// site, less than 0.09 at a distance of three cell radii, and less than 0.05 at four. If all
/// vertices are sites, however, psi_i is 1 at vertex i and 0 at others. psi_j is 0 in other
/// components, and at vertices without a face.
///
/// Vertices with given values (PoissonSolver::IsFixed()) belong to no cell, and psi_j is 0 there.
/// In their components the term A_j / A is absent, and the sum is 1 only away from given values.
/// With PoissonWeights::Uniform, vertex counts replace areas.
///
/// -Laplace u = f is solved in the space of these functions by sum_j K_ij lambda_j = b_i, where b_i
/// is the integral of f over cell i, K_ij = -c_ij, and rows of K sum to 0 (except for the flux to
/// given values). Then u = sum_j lambda_j psi_j is the finite element solution for f averaged over
/// cells, for any c_ij: K is symmetric, so u = mean + sum_i b_i gbar_i. The error decreases with
/// the square of the cell size.
///
/// Progress is reported by the threads of `parallel`, several simultaneously.
class DGG_CORE_EXPORT HarmonicSplines
{
public:
  /// The solver must be ready and outlive the object.
  explicit HarmonicSplines(const PoissonSolver& solver);
  ~HarmonicSplines();
  HarmonicSplines(const HarmonicSplines&) = delete;
  HarmonicSplines& operator=(const HarmonicSplines&) = delete;

  /// Computes cells and coefficients. Fails like CheckSplineSites(). Must be repeated after the
  /// solver has been prepared with other options.
  Status Prepare(
    const std::vector<Id>& sites, const ParallelFor& parallel, const ProgressCallback& progress);

  /// Returns, per vertex, the index of its site; NoId with given values or without a face.
  const std::vector<Id>& GetCells() const;

  /// Receives a function per vertex. The array is only valid during the call. Called in any order,
  /// by several threads simultaneously.
  using Consumer = std::function<void(Id site, const std::vector<double>& values)>;

  /// Computes psi_j of all sites, eight at a time.
  Status FindBasis(
    const ParallelFor& parallel, const ProgressCallback& progress, const Consumer& consume) const;

  /// Computes psi_j(x) at any points, by one Green's function per point: values[k * sites + j] is
  /// psi_j at point k. With GreensMethod::SingularitySubtraction, means over cells around
  /// x use the logarithm itself, so that functions are smooth across edges. If cells are single
  /// vertices, this makes a difference: psi is about 0.32 at its site and 0.11 at the neighbors. (A
  /// Green's function without means, and thus psi, would be infinite at vertices.) With
  /// Interpolated, functions are linear in faces and agree with FindBasis() at vertices.
  Status Evaluate(const std::vector<SurfacePoint>& points, GreensMethod method,
    const ParallelFor& parallel, const ProgressCallback& progress,
    std::vector<double>& values) const;

  /// Computes the coefficients lambda of a solution. `rightHandSide` is as in
  /// PoissonSolver::Solve(): per vertex, integrated sources, or given values. The coefficients of
  /// the sites in `given` are read from `coefficients`; the others are computed. In components
  /// where nothing is given, sources are balanced and the mean of lambda is 0. Fails if the
  /// equations cannot be solved to 1e-8: in cells of obtuse triangles some c_ij may be negative.
  Status Solve(const std::vector<double>& rightHandSide, const std::vector<Id>& given,
    std::vector<double>& coefficients) const;

  /// Computes sum_j lambda_j psi_j at vertices. `givenValues`, per vertex, contains the given
  /// values (other entries are ignored); empty means 0.
  Status Combine(const std::vector<double>& coefficients, const std::vector<double>& givenValues,
    std::vector<double>& values) const;

  /// Computes functions per vertex that interpolate each column of values at the sites, to 1e-9 of
  /// their range, as sums of basis functions. `atSites[j * sites + i]` is psi_j at site i, as
  /// computed by FindBasis(). Fails if the basis functions are linearly dependent, or values are
  /// not finite.
  Status Interpolate(const std::vector<double>& atSites,
    const std::vector<std::vector<double>>& siteValues, const ParallelFor& parallel,
    const ProgressCallback& progress, std::vector<std::vector<double>>& functions) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
