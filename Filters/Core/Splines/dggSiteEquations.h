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
/// The equations sum_j lambda_j f_j(x_i) = v_i for sites x_i and equally many functions f_j, which
/// are linear in faces. In a component without given values, the functions of its sites span the
/// constants.
class SiteEquations
{
public:
  explicit SiteEquations(const PoissonSystem& system)
    : System(system)
  {
  }

  /// `atSites(i, j)` is f_j(x_i). Fails if functions are linearly dependent.
  Status Prepare(const std::vector<SurfacePoint>& sites, const Eigen::MatrixXd& atSites);

  /// Replaces coefficients by functions per vertex, column by column.
  using Combine = std::function<Status(std::vector<std::vector<double>>& columns)>;

  /// Computes the functions that interpolate each column of values, eight at a time, with iterative
  /// refinement. Constants are reproduced exactly. Fails if values are not finite, their number
  /// differs from the number of sites, or a residual of 1e-9 of their range remains.
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
