// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Factorizations of sparse symmetric matrices. Internal.
#ifndef dggSparseFactor_h
#define dggSparseFactor_h

#include "dggTypes.h" // for Offset

#include <Eigen/SparseCholesky> // for the factorization
#include <Eigen/SparseCore>     // for matrices

#include <vector> // for solutions

namespace dgg
{
/// A fill-reducing order of the unknowns (AMD): the place of each in a permuted matrix.
std::vector<Id> FindEliminationOrder(const Eigen::SparseMatrix<double>& matrix);

/// Off-diagonal entries that the factor of a matrix has, given by the upper triangle of its pattern
/// (Liu, "The role of elimination trees in sparse factorization", 1990).
Offset CountFactorEntries(const Eigen::SparseMatrix<double>& upper);

/// The same unknown of several systems.
using SparseLanes = Eigen::Array<double, 8, 1>;

/// L D L^T of a positive definite matrix whose unknowns have been ordered already.
class SparseFactor
{
public:
  /// Bytes that the factor of a matrix takes while it is computed, given both of its triangles and
  /// how many entries the factor has (CountFactorEntries()).
  static double EstimateMemory(const Eigen::SparseMatrix<double>& matrix, Offset entries);

  /// From the upper triangle, with all entries of the diagonal, in any order. Where rounding leaves
  /// a pivot of 0, as among faces with next to no area, the diagonal is raised by 1e-10 of its
  /// largest entry. False when that fails, too.
  bool Compute(const Eigen::SparseMatrix<double>& upper);
  bool IsComputed() const { return this->Computed; }
  /// Whether the diagonal was raised: solutions then are those of a system nearby.
  bool IsRaised() const { return this->Raised; }
  void Clear();

  /// Replace the right-hand side by the solution. `Number` is double, ScaledNumber, or
  /// SparseLanes for that many systems at once, which costs half as much for each. Nothing is
  /// subtracted from numbers of the same sign where the matrix is an M-matrix and the right-hand
  /// side not negative: then every value has a small relative error, however small it is.
  template <typename Number>
  void Solve(std::vector<Number>& values) const;

private:
  using Factor =
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>>;
  Factor Decomposition;
  bool Computed = false;
  bool Raised = false;
};
}

#endif
