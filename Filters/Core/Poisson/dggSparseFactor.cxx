// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSparseFactor.h"

#include "dggScaledNumber.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace dgg
{
namespace
{
bool IsZero(double value)
{
  return value == 0.0;
}
bool IsZero(const ScaledNumber& value)
{
  return value.IsZero();
}
bool IsZero(const SparseLanes& values)
{
  return (values == 0.0).all();
}

/// Call `visit` with each entry of the diagonal. The entries of a column need not be in the order
/// of rows, as those of permuted matrices are not: SparseMatrix::diagonal() would search for them.
template <typename Visitor>
void ForEachOnDiagonal(Eigen::SparseMatrix<double>& matrix, Visitor&& visit)
{
  for (int column = 0; column < matrix.cols(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
    {
      if (entry.row() == column)
      {
        visit(entry.valueRef());
      }
    }
  }
}
}

EliminationOrder::EliminationOrder(const Eigen::SparseMatrix<double>& matrix)
  : MatrixEntries(matrix.nonZeros())
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(matrix, order); // old place of each new one
  const auto n = static_cast<std::size_t>(matrix.cols());
  auto places = std::make_shared<std::vector<Id>>(n);
  for (int place = 0; place < matrix.cols(); ++place)
  {
    (*places)[order.indices()[place]] = place;
  }
  this->Places = places;
  const Eigen::SparseMatrix<double> upper = this->Permute(matrix);
  std::vector<Id> parent(n, NoId);
  std::vector<Id> mark(n, NoId);
  for (Id column = 0; column < upper.cols(); ++column)
  {
    mark[column] = column;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(upper, column); entry; ++entry)
    {
      for (auto i = static_cast<Id>(entry.row()); mark[i] != column; i = parent[i])
      {
        parent[i] = parent[i] == NoId ? column : parent[i];
        mark[i] = column;
        ++this->FactorEntries;
      }
    }
  }
}

Status EliminationOrder::Check() const
{
  return this->FactorEntries <= std::numeric_limits<int>::max()
    ? Status::Success()
    : Status::Invalid("the factor of the linear system would have " +
        std::to_string(this->FactorEntries) +
        " entries, more than can be numbered: use a smaller mesh");
}

double EliminationOrder::EstimateFactorMemory() const
{
  // Rows and values of the factor; half of the matrix, permuted, of which Eigen makes a copy; the
  // diagonal, the beginnings of columns, and arrays to work with.
  constexpr double entry = sizeof(double) + sizeof(int);
  const auto n = this->Places ? static_cast<double>(this->Places->size()) : 0.0;
  return entry * (static_cast<double>(this->FactorEntries + this->MatrixEntries) + n) +
    n * (2.0 * sizeof(double) + 8.0 * sizeof(int));
}

std::vector<Id> EliminationOrder::FindLast(const std::vector<Id>& parts, Id numberOfParts) const
{
  std::vector<Id> last(static_cast<std::size_t>(numberOfParts), NoId);
  for (std::size_t v = 0; v < parts.size(); ++v)
  {
    Id& of = last[parts[v]];
    of = of == NoId || (*this->Places)[v] > (*this->Places)[of] ? static_cast<Id>(v) : of;
  }
  return last;
}

/// The upper triangle, in the order of elimination.
Eigen::SparseMatrix<double> EliminationOrder::Permute(
  const Eigen::SparseMatrix<double>& matrix) const
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation(matrix.cols());
  std::copy(this->Places->begin(), this->Places->end(), permutation.indices().data());
  Eigen::SparseMatrix<double> upper(matrix.rows(), matrix.cols());
  upper.selfadjointView<Eigen::Upper>() =
    matrix.selfadjointView<Eigen::Upper>().twistedBy(permutation);
  return upper;
}

bool SparseFactor::Compute(const EliminationOrder& order, const Eigen::SparseMatrix<double>& matrix,
  const std::vector<std::uint8_t>& isKnown)
{
  this->Clear();
  this->Places = order.Places;
  Eigen::SparseMatrix<double> upper = order.Permute(matrix);
  if (!isKnown.empty())
  {
    std::vector<std::uint8_t> isKnownAt(isKnown.size());
    for (std::size_t v = 0; v < isKnown.size(); ++v)
    {
      isKnownAt[(*this->Places)[v]] = isKnown[v];
    }
    for (int column = 0; column < upper.cols(); ++column)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(upper, column); entry; ++entry)
      {
        if (isKnownAt[column] || isKnownAt[entry.row()])
        {
          entry.valueRef() = entry.row() == column ? 1.0 : 0.0;
        }
      }
    }
  }
  this->Decomposition.compute(upper);
  if (this->Decomposition.info() != Eigen::Success)
  {
    double largest = 0.0;
    ForEachOnDiagonal(upper, [&](double& d) { largest = std::max(largest, std::abs(d)); });
    ForEachOnDiagonal(upper, [&](double& d) { d += 1e-10 * largest; });
    this->Decomposition.compute(upper);
    this->Raised = true;
  }
  this->Computed = this->Decomposition.info() == Eigen::Success;
  return this->Computed;
}

void SparseFactor::Clear()
{
  if (this->Computed)
  {
    this->Decomposition.compute(Eigen::SparseMatrix<double>(0, 0));
  }
  this->Computed = false;
  this->Raised = false;
}

template <typename Number>
void SparseFactor::Solve(std::vector<Number>& values) const
{
  const std::vector<Id>& places = *this->Places;
  std::vector<Number> inOrder(values.size());
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    inOrder[places[v]] = values[v];
  }
  this->SolveInOrder(inOrder);
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    values[v] = inOrder[places[v]];
  }
}

template <typename Number>
void SparseFactor::SolveInOrder(std::vector<Number>& values) const
{
  const Eigen::SparseMatrix<double>& lower = this->Decomposition.matrixL().nestedExpression();
  const int* const begin = lower.outerIndexPtr();
  const int* const rows = lower.innerIndexPtr();
  const double* const entries = lower.valuePtr();
  const auto diagonal = this->Decomposition.vectorD();
  const auto n = static_cast<int>(lower.cols());
  for (int j = 0; j < n; ++j)
  {
    if (!IsZero(values[j])) // few are not where there are few sources
    {
      const Number value = values[j];
      for (int p = begin[j]; p < begin[j + 1]; ++p)
      {
        values[rows[p]] += value * -entries[p];
      }
      values[j] = value * (1.0 / diagonal[j]);
    }
  }
  for (int j = n - 1; j >= 0; --j)
  {
    Number value = values[j];
    for (int p = begin[j]; p < begin[j + 1]; ++p)
    {
      value += values[rows[p]] * -entries[p];
    }
    values[j] = value;
  }
}

template void SparseFactor::Solve(std::vector<double>& values) const;
template void SparseFactor::Solve(std::vector<ScaledNumber>& values) const;
template void SparseFactor::Solve(std::vector<SparseLanes>& values) const;
}
