// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Functions with given values at sites. Internal.
#ifndef dggSiteEquations_h
#define dggSiteEquations_h

#include "dggParallel.h"      // for ParallelFor
#include "dggPoissonSystem.h" // for the system

#include <Eigen/Dense> // for the factor

#include <functional> // for Combine
#include <vector>     // for values

namespace dgg
{
/// sum_j lambda_j f_j(x_i) = v_i for sites x_i and as many functions f_j, which are linear in
/// faces. Those of the sites of a component without given values contain the constants there.
class SiteEquations
{
public:
  explicit SiteEquations(const PoissonSystem& system)
    : System(system)
  {
  }

  /// `atSites(i, j)` is f_j(x_i). Fails where functions depend on each other.
  Status Prepare(const std::vector<SurfacePoint>& sites, const Eigen::MatrixXd& atSites);

  /// Replaces coefficients by functions per vertex, column by column.
  using Combine = std::function<Status(std::vector<std::vector<double>>& columns)>;

  /// The functions that have the values of each column, eight at a time, refined until they do.
  /// Constants are so to the last bit. Fails where values are not finite, there are not as many as
  /// sites, or 1e-9 of their differences is left.
  Status Solve(const std::vector<std::vector<double>>& siteValues, const Combine& combine,
    const ParallelFor& parallel, const ProgressCallback& progress,
    std::vector<std::vector<double>>& functions) const;

private:
  Status CheckValues(const std::vector<std::vector<double>>& siteValues) const;
  std::vector<double> FindConstants(const std::vector<double>& values) const;
  Status SolveBlock(Offset begin, const std::vector<std::vector<double>>& siteValues,
    const Combine& combine, const ProgressCallback& progress,
    std::vector<std::vector<double>>& found) const;

  const PoissonSystem& System;
  std::vector<SurfacePoint> Sites;
  Eigen::VectorXd Scales; // per function
  Eigen::PartialPivLU<Eigen::MatrixXd> Factor;
};
}

#endif
