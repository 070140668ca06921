// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Factorizations of sparse symmetric matrices. Internal.
#ifndef dggSparseFactor_h
#define dggSparseFactor_h

#include "dggTypes.h" // for Offset

#include <Eigen/SparseCore> // for matrices

#include <cstdint> // for flags
#include <memory>  // for the order
#include <vector>  // for solutions

namespace dgg
{
/// In which order unknowns are eliminated so that a factor has few entries: approximate minimum
/// degree. Factors of all matrices with the same pattern share it.
class EliminationOrder
{
public:
  EliminationOrder() = default;
  /// From both triangles of a symmetric matrix.
  explicit EliminationOrder(const Eigen::SparseMatrix<double>& matrix);

  /// Off-diagonal entries that a factor has (Liu, "The role of elimination trees in sparse
  /// factorization", 1990).
  Offset GetNumberOfFactorEntries() const { return this->FactorEntries; }
  /// Bytes that a factor takes while it is computed.
  double EstimateFactorMemory() const;
  /// The unknown of each part that is eliminated last.
  std::vector<Id> FindLast(const std::vector<Id>& parts, Id numberOfParts) const;

private:
  friend class SparseFactor;

  Eigen::SparseMatrix<double> Permute(const Eigen::SparseMatrix<double>& matrix) const;

  /// Where entries of a factor are, by places in the order.
  struct Pattern
  {
    std::vector<Id> Places;      ///< of unknowns
    std::vector<Id> Parents;     ///< the row of the first entry of each column, NoId for none
    std::vector<Offset> Columns; ///< where the entries of each column begin, and their number
  };

  std::shared_ptr<const Pattern> Shared;
  Offset MatrixEntries = 0;
  Offset FactorEntries = 0;
};

/// The same unknown of several systems.
using SparseLanes = Eigen::Array<double, 8, 1>;

/// L D L^T of a symmetric matrix, without pivoting. Eigen's factorization of it takes seconds on
/// large meshes, and can neither report progress nor be stopped; only its ordering is used.
class SparseFactor
{
public:
  /// From a matrix with the pattern of the order and all entries of the diagonal, of which the
  /// upper triangle is read. Equations of unknowns that are known, if flags are given, say that
  /// the unknown is its right-hand side, and no other equation has it. Where rounding leaves a
  /// pivot of 0, as among faces with next to no area, the diagonal is raised by 1e-10 of its
  /// largest entry; it is an error when that fails, too. Progress is reported after each few
  /// million operations.
  Status Compute(const EliminationOrder& order, const Eigen::SparseMatrix<double>& matrix,
    const std::vector<std::uint8_t>& isKnown = {}, const ProgressCallback& progress = {});
  bool IsComputed() const { return this->Computed; }
  /// Whether the diagonal was raised: solutions then are those of a system nearby.
  bool IsRaised() const { return this->Raised; }
  /// Pivots below 0: as many as eigenvalues (Sylvester).
  Id CountNegative() const;
  void Clear();

  /// Replace the right-hand side by the solution. `Number` is double, ScaledNumber, or
  /// SparseLanes for that many systems at once, which costs half as much for each. Nothing is
  /// subtracted from numbers of the same sign where the matrix is an M-matrix and the right-hand
  /// side not negative: then every value has a small relative error, however small it is.
  template <typename Number>
  void Solve(std::vector<Number>& values) const;

private:
  Status Factorize(const Eigen::SparseMatrix<double>& upper, const ProgressCallback& progress);
  template <typename Number>
  void SolveInOrder(std::vector<Number>& values) const;

  std::shared_ptr<const EliminationOrder::Pattern> Pattern;
  std::vector<Id> Rows; ///< of the entries of L below the diagonal, column by column
  std::vector<double> Entries;
  std::vector<double> Diagonal; ///< D
  bool Computed = false;
  bool Raised = false;
};
}

#endif
