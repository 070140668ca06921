// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Poisson equations on the cells of sites. Internal.
#ifndef dggSiteEquations_h
#define dggSiteEquations_h

#include "dggSplineCells.h" // for the cells

#include <Eigen/SparseCore> // for the matrix

#include <cstdint> // for flags
#include <vector>  // for values

namespace dgg
{
/// K lambda = b, with some of the lambda given. Components where nothing is given are balanced, and
/// have the mean 0.
class SiteEquations
{
public:
  /// The right-hand side is per vertex: integrated sources, or given values. The cells must outlive
  /// the object.
  SiteEquations(const PoissonSystem& system, const SplineCells& cells,
    const std::vector<double>& rightHandSide);

  void Give(Id site, double value);

  /// To be called once. False when some cells do not conduct, or conduct so badly that the
  /// equations cannot be solved to 1e-8.
  bool Solve(std::vector<double>& coefficients);

private:
  void Balance();
  void PinFloatingComponents();
  Eigen::SparseMatrix<double> TakeKnownValuesOff();
  void Center(std::vector<double>& coefficients) const;

  const SplineCells& Cells;
  Id Count;
  Eigen::VectorXd Sources;
  std::vector<double> Values;           // those that are given
  std::vector<std::uint8_t> IsKnown;    // per site
  std::vector<std::uint8_t> IsFloating; // per component, whether nothing is given
};
}

#endif
