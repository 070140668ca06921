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
/// parts the vertices into cells. With cell areas A_j, the total area A of the component, g the
/// Green's function, gbar_j its mean over cell j, and c_ij = length of the border between two
/// cells / distance of their sites, the basis function of site j is
///
///     psi_j(x) = A_j / A + sum_i c_ij (gbar_j(x) - gbar_i(x)),
///
/// with g positive at its pole (in the thesis it is negative, which is why it subtracts the other
/// way round). -Laplace psi_j is constant in each cell. The psi_j sum to 1 and have the mean A_j /
/// A. They do not interpolate, as other splines do not: on the unit sphere with 40 sites psi_j is
/// 0.57 to 0.70 at its site, less than 0.09 three cell radii away, and 0.05 four. When all vertices
/// are sites, though, psi_i is 1 at vertex i and 0 at others. It is 0 in other components, and at
/// vertices without a face.
///
/// Where values are given (PoissonSolver::IsFixed()), vertices with these are in no cell, psi_j is
/// 0 there, there is no A_j / A, and sums are 1 only away from there. With PoissonWeights::Uniform,
/// numbers of vertices take the place of areas.
///
/// -Laplace u = f is solved in the space of these functions by sum_j K_ij lambda_j = b_i, where b_i
/// is the integral of f over cell i, K_ij = -c_ij, and rows of K sum to 0 (but for what flows to
/// given values). Then u = sum_j lambda_j psi_j is what finite elements make of f, averaged over
/// cells, whatever the c_ij are: K is symmetric, so u = mean + sum_i b_i gbar_i. The error falls
/// like the square of the size of cells.
///
/// Progress is reported by the threads of `parallel`, several at once.
class DGG_CORE_EXPORT HarmonicSplines
{
public:
  /// The solver must be ready and outlive this.
  explicit HarmonicSplines(const PoissonSolver& solver);
  ~HarmonicSplines();
  HarmonicSplines(const HarmonicSplines&) = delete;
  HarmonicSplines& operator=(const HarmonicSplines&) = delete;

  /// Find cells and coefficients. Fails as CheckSplineSites() does. To be done again when the
  /// solver has been prepared with other options.
  Status Prepare(
    const std::vector<Id>& sites, const ParallelFor& parallel, const ProgressCallback& progress);

  /// Per vertex, the number of its site; NoId with given values or without a face.
  const std::vector<Id>& GetCells() const;

  /// Receives a function per vertex. The array is good during the call only. Called in any order,
  /// by several threads at once.
  using Consumer = std::function<void(Id site, const std::vector<double>& values)>;

  /// psi_j of all sites, eight solved for at a time.
  Status FindBasis(
    const ParallelFor& parallel, const ProgressCallback& progress, const Consumer& consume) const;

  /// psi_j(x) at any points, by one Green's function for each: values[k * sites + j] is that of
  /// site j at point k. With GreensMethod::SingularitySubtraction means over cells around x are
  /// those of the logarithm itself, so that functions are smooth across edges. Where cells are
  /// single vertices, that makes a difference: psi is about 0.32 at its site and 0.11 at the
  /// neighbours. (A Green's function without means would be infinite at vertices, and so would
  /// psi.) With Interpolated they are linear in faces and have the values of FindBasis() at
  /// vertices.
  Status Evaluate(const std::vector<SurfacePoint>& points, GreensMethod method,
    const ParallelFor& parallel, const ProgressCallback& progress,
    std::vector<double>& values) const;

  /// The coefficients lambda of a solution. `rightHandSide` is what PoissonSolver::Solve() takes:
  /// per vertex, integrated sources, or given values. Those of the sites in `given` are given: they
  /// are read from `coefficients`, which is filled. In components where nothing is given, sources
  /// are balanced and the mean of lambda is 0. Fails where the equations cannot be solved to 1e-8:
  /// in cells of obtuse triangles some c_ij may be negative.
  Status Solve(const std::vector<double>& rightHandSide, const std::vector<Id>& given,
    std::vector<double>& coefficients) const;

  /// sum_j lambda_j psi_j at vertices. `givenValues`, per vertex, are those of vertices with given
  /// values (others are not used), or empty for 0.
  Status Combine(const std::vector<double>& coefficients, const std::vector<double>& givenValues,
    std::vector<double>& values) const;

  /// Functions per vertex that have the values of each column at the sites, to 1e-9 of their
  /// differences: the sums of basis functions that do. `atSites[j * sites + i]` is psi_j at site i,
  /// as FindBasis() has found it. Fails where these depend on each other, or values are not finite.
  Status Interpolate(const std::vector<double>& atSites,
    const std::vector<std::vector<double>>& siteValues, const ParallelFor& parallel,
    const ProgressCallback& progress, std::vector<std::vector<double>>& functions) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
