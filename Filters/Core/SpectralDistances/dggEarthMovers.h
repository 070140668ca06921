// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The earth mover's distance of two distributions on a surface.
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
/// Where the gap cannot be seen any more for rounding.
constexpr double LeastEarthMoversGap = 1e-8;

struct EarthMoversOptions
{
  /// Most iterations, each a factorization; 0 gives the cost of the flow that is a gradient, which
  /// is an upper bound. Some 10 to 100 are needed.
  int MostIterations = 200;
  /// Stop when the bounds are this close, relative to the upper one.
  double Tolerance = 1e-2;
  ProgressCallback Progress; ///< may be empty
};

struct EarthMoversResult
{
  /// The cost of the best flow found, mass times length.
  double Distance = 0.0;
  /// No flow through the elements costs less: what a potential with slopes of at most 1 earns.
  double LowerBound = 0.0;
  int Iterations = 0;
  /// How far the two may be from the optimum, relative to the distance.
  double GetGap() const
  {
    return this->Distance > 0.0 ? (this->Distance - this->LowerBound) / this->Distance : 0.0;
  }
  /// The potential of the lower bound, per vertex; mass goes down it.
  std::vector<double> Potential;
  /// The best flow, mass per length, per face of the mesh in the frame of its first half-edge (x
  /// along it, y to the apex). Empty with IntrinsicDelaunay, where elements are not the faces.
  std::vector<Point2> Flow;
};

/// Add a point mass to masses per vertex, by barycentric coordinates.
DGG_CORE_EXPORT Status AddPointMass(
  const SurfaceMesh& mesh, const SurfacePoint& point, double mass, std::vector<double>& masses);

/// The least cost of moving one distribution to the other within the surface, W1 (Beckmann's
/// problem; Solomon, Rustamov, Guibas and Butscher, "Earth mover's distances on discrete surfaces",
/// 2014): the integral of |J| over flows J, constant per face, whose weak divergence is the
/// difference of the masses, through no boundary. Found by an interior point method on flows and
/// potentials, with one factorization in each step, which long triangles hardly slow down. So
/// gradients, rotations and flows around handles are all considered, where the paper has a basis of
/// few eigenfunctions.
///
/// Potentials are linear in each face and not steeper than 1. So between two point masses the
/// optimum, and the lower bound, is never more than the geodesic distance, to which it tends as the
/// mesh is refined.
///
/// The solver must be ready, without given values, and outlive it. Both distributions must have the
/// same mass in each component, see BalanceMasses().
class DGG_CORE_EXPORT EarthMovers
{
public:
  explicit EarthMovers(const PoissonSolver& solver)
    : Solver(solver)
  {
  }

  /// Masses per vertex, integrated.
  Status Run(const std::vector<double>& from, const std::vector<double>& to,
    const EarthMoversOptions& options, EarthMoversResult& result) const;

private:
  const PoissonSolver& Solver;
};

/// Masses, as a part of the mass of all, that may be missing in one of two distributions. Sums of
/// densities in single precision differ by less.
constexpr double MassTolerance = 1e-6;

/// Scale masses per vertex, which must not be negative, so that both distributions sum to 1 (to 0
/// when there is no mass) and have the same mass in each component. `total` is what they summed to;
/// 1 when they are to be normalized.
///
/// Fails when a mass is negative or not finite, or a sum is not; when totals differ by more than
/// MassTolerance, unless they are to be normalized, which needs some mass in both; when masses
/// within a component differ by more than MassTolerance of the total: nothing can get there.
DGG_CORE_EXPORT Status BalanceMasses(const SurfaceMesh& mesh, bool normalize,
  std::vector<double>& from, std::vector<double>& to, double& total);
}

#endif
