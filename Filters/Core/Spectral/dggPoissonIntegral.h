// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Solutions of Poisson equations at any point of a surface, as integrals of Green's functions.
#ifndef dggPoissonIntegral_h
#define dggPoissonIntegral_h

#include "dggGreensFunction.h" // for methods
#include "dggParallel.h"       // for ParallelFor
#include "dggPoissonSolver.h"  // for PoissonSolver
#include "dggSurfacePoint.h"   // for points

#include <cstddef>    // for std::size_t
#include <functional> // for PointVisitor
#include <vector>     // for sources and solutions

namespace dgg
{
/// The solution u of -Laplace u = f in closed form,
///
///     u(x) = h(x) + sum_y g(x, y) b_y,
///
/// b_y the integral of f around vertex y, g the Green's function of x. g(x, y) is the mean over the
/// cell of y, so that it is finite everywhere and the logarithm around x is integrated exactly
/// (GreensResult::Integrals). h is the harmonic function with the values that are given, 0 where
/// none are.
///
/// At vertices, and with GreensMethod::Interpolated anywhere, u is the solution of finite elements:
/// PoissonSolver::Solve(), linear in faces. With GreensMethod::SingularitySubtraction, it is of the
/// same order, without the kinks at edges. A point costs one Green's function, so this is for few
/// points and many right-hand sides.
///
/// Progress is told by the threads of `parallel`, one at a time.
class PoissonIntegral
{
public:
  /// The solver must be ready and outlive this.
  explicit PoissonIntegral(const PoissonSolver& solver);

  /// Each right-hand side is what PoissonSolver::Solve() takes: per vertex, integrated sources, or
  /// the value where it is given. `solutions[r][k]` is the value of solution r at point k. Where no
  /// values are given, its mean is 0, and sources are balanced.
  ///
  /// Fails when a right-hand side is not finite or has another size than the mesh, and where
  /// PoissonSolver::CheckPole() does, but not at points whose values are given.
  Status Run(const std::vector<SurfacePoint>& points,
    const std::vector<std::vector<double>>& rightHandSides, GreensMethod method,
    const ParallelFor& parallel, const ProgressCallback& progress,
    std::vector<std::vector<double>>& solutions) const;

  /// Receives, for a point, g(x, y) of all vertices y: 0 at those with given values, or without a
  /// face. Called in any order, by several threads at once.
  using PointVisitor = std::function<void(std::size_t point, const std::vector<double>& greens)>;

  /// The Green's functions alone. Points with given values, where they are 0, and in components
  /// that are thin (PoissonSystem::IsThin()) and without given values, are passed over.
  Status ForEachPoint(const std::vector<SurfacePoint>& points, GreensMethod method,
    const ParallelFor& parallel, const ProgressCallback& progress, const PointVisitor& visit) const;

private:
  const PoissonSolver& Solver;
  GreensFunction Function;
};
}

#endif
