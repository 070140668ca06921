// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Earth mover's distance between two distributions on a surface.
#ifndef dggEarthMovers_h
#define dggEarthMovers_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggPoissonSolver.h" // for PoissonSolver
#include "dggSurfaceMesh.h"   // for SurfaceMesh
#include "dggSurfacePoint.h"  // for point masses
#include "dggUnfolding.h"     // for vectors in faces

#include <vector> // for masses

namespace dgg
{
/// Smallest gap that can be resolved despite rounding.
constexpr double LeastEarthMoversGap = 1e-8;

struct EarthMoversOptions
{
  /// Maximum number of iterations, each a factorization; usually 10 to 100 suffice. 0 gives the
  /// cost of the gradient flow, which is an upper bound.
  int MostIterations = 200;
  /// Stop when the gap between the bounds, relative to the upper bound, is below this value.
  double Tolerance = 1e-2;
  ProgressCallback Progress; ///< may be empty
};

struct EarthMoversResult
{
  /// Cost of the best flow found, mass times length.
  double Distance = 0.0;
  /// Lower bound of the cost of any flow through the elements: the dual value of a potential with
  /// slopes of at most 1.
  double LowerBound = 0.0;
  int Iterations = 0;
  /// Returns the gap between the bounds, relative to the distance.
  double GetGap() const
  {
    return this->Distance > 0.0 ? (this->Distance - this->LowerBound) / this->Distance : 0.0;
  }
  /// Potential of the lower bound, per vertex; mass flows towards smaller values.
  std::vector<double> Potential;
  /// Best flow, mass per length, per mesh face in the frame of its first half-edge (x along the
  /// half-edge, y towards the apex). Empty with IntrinsicDelaunay, where elements are not the
  /// faces.
  std::vector<Point2> Flow;
};

/// Adds a point mass to per-vertex masses, by barycentric coordinates.
DGG_CORE_EXPORT Status AddPointMass(
  const SurfaceMesh& mesh, const SurfacePoint& point, double mass, std::vector<double>& masses);

/// The minimal cost of moving one distribution to the other within the surface, W1 (Beckmann's
/// problem; Solomon, Rustamov, Guibas and Butscher, "Earth mover's distances on discrete surfaces",
/// 2014): the integral of |J| over flows J, constant per face, whose weak divergence is the
/// difference of the masses, with no flow across the boundary. Solved by an interior-point method
/// on flows and potentials, with one factorization per step; elongated triangles hardly affect
/// convergence. All flows are admissible (gradients, rotations and flows around handles), whereas
/// the paper uses a basis of few eigenfunctions.
///
/// Potentials are linear in each face with slopes of at most 1. Hence between two point masses the
/// optimum, and the lower bound, never exceeds the geodesic distance, to which it converges under
/// refinement of the mesh.
///
/// The solver must be ready, have no given values, and outlive the object. Both distributions must
/// have the same mass in each component, see BalanceMasses().
class DGG_CORE_EXPORT EarthMovers
{
public:
  explicit EarthMovers(const PoissonSolver& solver)
    : Solver(solver)
  {
  }

  /// Computes the distance between two distributions, given as integrated masses per vertex.
  Status Run(const std::vector<double>& from, const std::vector<double>& to,
    const EarthMoversOptions& options, EarthMoversResult& result) const;

private:
  const PoissonSolver& Solver;
};

/// Largest relative difference between the total masses of two distributions. Sums of densities in
/// single precision differ by less.
constexpr double MassTolerance = 1e-6;

/// Scales non-negative masses per vertex so that both distributions sum to 1 (to 0 if there is no
/// mass) and have the same mass in each component. `total` is the original sum; 1 with `normalize`.
///
/// Fails if a mass is negative or not finite, or a sum is not finite; if totals differ by more than
/// MassTolerance, unless normalized, which requires positive mass in both; or if masses within a
/// component differ by more than MassTolerance of the total, since no mass can flow between
/// components.
DGG_CORE_EXPORT Status BalanceMasses(const SurfaceMesh& mesh, bool normalize,
  std::vector<double>& from, std::vector<double>& to, double& total);
}

#endif
