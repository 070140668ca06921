// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Factorizations of sparse symmetric matrices. Internal.
#ifndef dggSparseFactor_h
#define dggSparseFactor_h

#include "dggStatus.h" // for Status

#include <Eigen/SparseCore> // for matrices

#include <cstdint> // for flags
#include <memory>  // for the order
#include <vector>  // for solutions

namespace dgg
{
/// Elimination order that keeps the number of entries of a factor small: approximate minimum
/// degree. Shared by the factors of all matrices with the same pattern.
class EliminationOrder
{
public:
  EliminationOrder() = default;
  /// Computes the order from a symmetric matrix with both triangles stored.
  explicit EliminationOrder(const Eigen::SparseMatrix<double>& matrix);

  /// Returns the number of off-diagonal entries of a factor (Liu, "The role of elimination trees in
  /// sparse factorization", 1990).
  Offset GetNumberOfFactorEntries() const { return this->FactorEntries; }
  /// Returns the peak memory in bytes while a factor is computed.
  double EstimateFactorMemory() const;
  /// Returns, for each part, the unknown that is eliminated last.
  std::vector<Id> FindLast(const std::vector<Id>& parts, Id numberOfParts) const;

private:
  friend class SparseFactor;

  Eigen::SparseMatrix<double> Permute(const Eigen::SparseMatrix<double>& matrix) const;

  /// Positions of the entries of a factor, indexed by the elimination order.
  struct Pattern
  {
    std::vector<Id> Places;      ///< position of each unknown in the order
    std::vector<Id> Parents;     ///< row of the first entry of each column, NoId for none
    std::vector<Offset> Columns; ///< offset of the entries of each column, and total number
  };

  std::shared_ptr<const Pattern> Shared;
  Offset MatrixEntries = 0;
  Offset FactorEntries = 0;
};

/// One unknown of several systems.
using SparseLanes = Eigen::Array<double, 8, 1>;

/// L D L^T factorization of a symmetric matrix, without pivoting. Eigen's factorization takes
/// seconds on large meshes and can neither report progress nor be stopped; only its ordering is
/// used.
class SparseFactor
{
public:
  /// Factorizes a matrix with the pattern of the order and all diagonal entries, of which the upper
  /// triangle is read. If `isKnown` is not empty, the equations of flagged unknowns are replaced by
  /// "unknown = right-hand side", and these unknowns are removed from all other equations. If
  /// rounding leads to a zero pivot, as among nearly degenerate faces, the diagonal is increased by
  /// 1e-10 of its largest entry; an error if that fails as well. Progress is reported every few
  /// million operations.
  Status Compute(const EliminationOrder& order, const Eigen::SparseMatrix<double>& matrix,
    const std::vector<std::uint8_t>& isKnown = {}, const ProgressCallback& progress = {});
  bool IsComputed() const { return this->Computed; }
  /// Returns true if the diagonal was increased, so that solutions belong to a slightly
  /// perturbed system.
  bool IsRaised() const { return this->Raised; }
  /// Returns the number of negative pivots, which equals the number of negative eigenvalues
  /// (Sylvester's law of inertia).
  Id CountNegative() const;
  void Clear();

  /// Replaces the right-hand side by the solution. `Number` is double, ScaledNumber, or SparseLanes
  /// for that many systems together, at half the cost per system. For an M-matrix and a
  /// non-negative right-hand side there is no cancellation: every value has a small relative error,
  /// however small the value is.
  template <typename Number>
  void Solve(std::vector<Number>& values) const;

private:
  Status Factorize(const Eigen::SparseMatrix<double>& upper, const ProgressCallback& progress);
  template <typename Number>
  void SolveInOrder(std::vector<Number>& values) const;

  std::shared_ptr<const EliminationOrder::Pattern> Pattern;
  std::vector<Id> Rows; ///< rows of the entries of L below the diagonal, column by column
  std::vector<double> Entries;
  std::vector<double> Diagonal; ///< D
  bool Computed = false;
  bool Raised = false;
};
}

#endif
