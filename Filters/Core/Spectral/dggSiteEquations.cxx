// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSiteEquations.h"

#include <Eigen/SparseCholesky> // for the factorization

#include <algorithm>
#include <cstddef>
#include <limits>

namespace dgg
{
namespace
{
using Entries = Eigen::SparseMatrix<double>::InnerIterator;

/// Largest residual of a solution, relative to the right-hand side, and what rounding may do.
constexpr double Tolerance = 1e-8;
}

SiteEquations::SiteEquations(
  const PoissonSystem& system, const SplineCells& cells, const std::vector<double>& rightHandSide)
  : Cells(cells)
  , Count(static_cast<Id>(cells.Components.size()))
  , Sources(Eigen::VectorXd::Zero(cells.Stiffness.cols()))
  , Values(cells.Components.size(), 0.0)
  , IsKnown(cells.Components.size(), 0)
  , IsFloating(system.GetNumberOfComponents(), 0)
{
  for (Id c = 0; c < system.GetNumberOfComponents(); ++c)
  {
    this->IsFloating[c] = system.IsFree(c) ? 1 : 0;
  }
  for (std::size_t v = 0; v < rightHandSide.size(); ++v)
  {
    if (cells.Cells[v] != NoId)
    {
      this->Sources[cells.Cells[v]] += rightHandSide[v];
    }
  }
  for (const SplineCells::Rim& rim : cells.Rims)
  {
    this->Sources[rim.Site] += rim.Coefficient * rightHandSide[rim.Vertex];
  }
}

void SiteEquations::Give(Id site, double value)
{
  this->Values[site] = value;
  this->IsKnown[site] = 1;
  this->IsFloating[this->Cells.Components[site]] = 0;
}

bool SiteEquations::Solve(std::vector<double>& coefficients)
{
  this->Balance();
  this->PinFloatingComponents();
  const Eigen::SparseMatrix<double> matrix = this->TakeKnownValuesOff();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success)
  {
    return false;
  }
  // Borders through obtuse triangles may have negative lengths, so that K is indefinite. There are
  // no pivots: what small ones spoil, a step of refinement mends, or else it is told.
  Eigen::VectorXd solution = factor.solve(this->Sources);
  Eigen::VectorXd residual = this->Sources - matrix * solution;
  solution += factor.solve(residual);
  residual = this->Sources - matrix * solution;
  // Where the matrix is singular up to rounding, values are so large that they cancel.
  const Eigen::VectorXd sizes = matrix.cwiseAbs() * solution.cwiseAbs();
  const double rounding = std::numeric_limits<double>::epsilon() * sizes.lpNorm<Eigen::Infinity>();
  const bool isSolved = solution.allFinite() &&
    residual.lpNorm<Eigen::Infinity>() <= Tolerance * this->Sources.lpNorm<Eigen::Infinity>() &&
    rounding <= Tolerance * this->Sources.lpNorm<1>();
  coefficients.assign(solution.data(), solution.data() + solution.size());
  this->Center(coefficients);
  return isSolved;
}

void SiteEquations::Balance()
{
  std::vector<double> totals(this->IsFloating.size(), 0.0);
  for (Id i = 0; i < this->Count; ++i)
  {
    totals[this->Cells.Components[i]] += this->Sources[i];
  }
  for (Id i = 0; i < this->Count; ++i)
  {
    const Id c = this->Cells.Components[i];
    this->Sources[i] -= this->IsFloating[c] ? totals[c] * this->Cells.Weights[i] : 0.0;
  }
}

/// One value is 0 until the mean is known.
void SiteEquations::PinFloatingComponents()
{
  std::vector<std::uint8_t> isPinned(this->IsFloating.size(), 0);
  for (Id i = 0; i < this->Count; ++i)
  {
    const Id c = this->Cells.Components[i];
    this->IsKnown[i] = this->IsKnown[i] || (this->IsFloating[c] && !isPinned[c]) ? 1 : 0;
    isPinned[c] = 1;
  }
}

/// The matrix with rows and columns of known values replaced by those of the identity.
Eigen::SparseMatrix<double> SiteEquations::TakeKnownValuesOff()
{
  Eigen::SparseMatrix<double> matrix = this->Cells.Stiffness;
  for (int column = 0; column < matrix.cols(); ++column)
  {
    for (Entries entry(matrix, column); entry; ++entry)
    {
      const auto row = entry.row();
      if (this->IsKnown[column] && !this->IsKnown[row])
      {
        this->Sources[row] -= entry.value() * this->Values[column];
      }
      if (this->IsKnown[column] || this->IsKnown[row])
      {
        entry.valueRef() = row == column ? 1.0 : 0.0;
      }
    }
  }
  for (Id i = 0; i < this->Count; ++i)
  {
    this->Sources[i] = this->IsKnown[i] ? this->Values[i] : this->Sources[i];
  }
  return matrix;
}

void SiteEquations::Center(std::vector<double>& coefficients) const
{
  std::vector<double> means(this->IsFloating.size(), 0.0);
  for (Id i = 0; i < this->Count; ++i)
  {
    means[this->Cells.Components[i]] += this->Cells.Weights[i] * coefficients[i];
  }
  for (Id i = 0; i < this->Count; ++i)
  {
    const Id c = this->Cells.Components[i];
    coefficients[i] -= this->IsFloating[c] ? means[c] : 0.0;
  }
}
}
