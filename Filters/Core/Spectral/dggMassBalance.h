// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Two distributions of the same mass, for the earth mover's distance.
#ifndef dggMassBalance_h
#define dggMassBalance_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for masses

namespace dgg
{
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
Status BalanceMasses(const SurfaceMesh& mesh, bool normalize, std::vector<double>& from,
  std::vector<double>& to, double& total);
}

#endif
