// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSparseFactor.h"

#include "dggScaledNumber.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>

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

std::vector<Id> FindEliminationOrder(const Eigen::SparseMatrix<double>& matrix)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(matrix, order); // old place of each new one
  std::vector<Id> places(static_cast<std::size_t>(matrix.cols()));
  for (int place = 0; place < matrix.cols(); ++place)
  {
    places[order.indices()[place]] = place;
  }
  return places;
}

Offset CountFactorEntries(const Eigen::SparseMatrix<double>& upper)
{
  const auto n = static_cast<std::size_t>(upper.cols());
  std::vector<Id> parent(n, NoId);
  std::vector<Id> mark(n, NoId);
  Offset count = 0;
  for (Id column = 0; column < upper.cols(); ++column)
  {
    mark[column] = column;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(upper, column); entry; ++entry)
    {
      for (auto i = static_cast<Id>(entry.row()); mark[i] != column; i = parent[i])
      {
        parent[i] = parent[i] == NoId ? column : parent[i];
        mark[i] = column;
        ++count;
      }
    }
  }
  return count;
}

double SparseFactor::EstimateMemory(const Eigen::SparseMatrix<double>& matrix, Offset entries)
{
  // Rows and values of the factor; half of the matrix, permuted, of which Eigen makes a copy; the
  // diagonal, the beginnings of columns, and arrays to work with.
  constexpr double entry = sizeof(double) + sizeof(int);
  const auto n = static_cast<double>(matrix.cols());
  return entry * (static_cast<double>(entries) + static_cast<double>(matrix.nonZeros()) + n) +
    n * (2.0 * sizeof(double) + 8.0 * sizeof(int));
}

bool SparseFactor::Compute(const Eigen::SparseMatrix<double>& upper)
{
  this->Clear();
  this->Decomposition.compute(upper);
  if (this->Decomposition.info() != Eigen::Success)
  {
    Eigen::SparseMatrix<double> raised = upper;
    double largest = 0.0;
    ForEachOnDiagonal(raised, [&](double& d) { largest = std::max(largest, std::abs(d)); });
    ForEachOnDiagonal(raised, [&](double& d) { d += 1e-10 * largest; });
    this->Decomposition.compute(raised);
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
