// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSparseFactor.h"

#include "dggProgressPart.h"
#include "dggScaledNumber.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dgg
{
namespace
{
/// Products computed by a factorization between two progress reports.
constexpr Offset WorkPerReport = 1 << 22;

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

/// Calls `visit` with each diagonal entry. SparseMatrix::diagonal() is not applicable because it
/// searches sorted columns, and columns of permuted matrices are not sorted.
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
  Eigen::AMDOrdering<int>()(matrix, order); // old index of each new one
  const auto n = static_cast<std::size_t>(matrix.cols());
  auto pattern = std::make_shared<Pattern>();
  this->Shared = pattern;
  pattern->Places.resize(n);
  for (int place = 0; place < matrix.cols(); ++place)
  {
    pattern->Places[order.indices()[place]] = place;
  }
  const Eigen::SparseMatrix<double> upper = this->Permute(matrix);
  std::vector<Id>& parent = pattern->Parents;
  parent.assign(n, NoId);
  pattern->Columns.assign(n + 1, 0);
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
        ++pattern->Columns[i + 1];
      }
    }
  }
  std::partial_sum(pattern->Columns.begin(), pattern->Columns.end(), pattern->Columns.begin());
  this->FactorEntries = pattern->Columns.back();
}

double EliminationOrder::EstimateFactorMemory() const
{
  // Rows and values of the factor; half of the permuted matrix; the diagonal, the column offsets,
  // and workspace arrays.
  constexpr double entry = sizeof(double) + sizeof(int);
  const auto n = this->Shared ? static_cast<double>(this->Shared->Places.size()) : 0.0;
  return entry * (static_cast<double>(this->FactorEntries + this->MatrixEntries) + n) +
    n * (2.0 * sizeof(double) + 8.0 * sizeof(int));
}

std::vector<Id> EliminationOrder::FindLast(const std::vector<Id>& parts, Id numberOfParts) const
{
  std::vector<Id> last(static_cast<std::size_t>(numberOfParts), NoId);
  for (std::size_t v = 0; v < parts.size(); ++v)
  {
    Id& of = last[parts[v]];
    const std::vector<Id>& places = this->Shared->Places;
    of = of == NoId || places[v] > places[of] ? static_cast<Id>(v) : of;
  }
  return last;
}

/// Returns the upper triangle, permuted to the elimination order.
Eigen::SparseMatrix<double> EliminationOrder::Permute(
  const Eigen::SparseMatrix<double>& matrix) const
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation(matrix.cols());
  const std::vector<Id>& places = this->Shared->Places;
  std::copy(places.begin(), places.end(), permutation.indices().data());
  Eigen::SparseMatrix<double> upper(matrix.rows(), matrix.cols());
  upper.selfadjointView<Eigen::Upper>() =
    matrix.selfadjointView<Eigen::Upper>().twistedBy(permutation);
  return upper;
}

Status SparseFactor::Compute(const EliminationOrder& order,
  const Eigen::SparseMatrix<double>& matrix, const std::vector<std::uint8_t>& isKnown,
  const ProgressCallback& progress)
{
  this->Clear();
  this->Pattern = order.Shared;
  Eigen::SparseMatrix<double> upper = order.Permute(matrix);
  if (!isKnown.empty())
  {
    std::vector<std::uint8_t> isKnownAt(isKnown.size());
    for (std::size_t v = 0; v < isKnown.size(); ++v)
    {
      isKnownAt[this->Pattern->Places[v]] = isKnown[v];
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
  Status status = this->Factorize(upper, progress);
  if (!status.IsOk() && !status.IsAborted())
  {
    double largest = 0.0;
    ForEachOnDiagonal(upper, [&](double& d) { largest = std::max(largest, std::abs(d)); });
    ForEachOnDiagonal(upper, [&](double& d) { d += 1e-10 * largest; });
    status = this->Factorize(upper, progress);
    this->Raised = true;
  }
  this->Computed = status.IsOk();
  if (!this->Computed)
  {
    this->Clear();
  }
  return status;
}

/// Up-looking factorization: the entries of a row of L are the solution of the system of all
/// previous rows (T. A. Davis, "Direct methods for sparse linear systems", 2006, section 4.7).
Status SparseFactor::Factorize(
  const Eigen::SparseMatrix<double>& upper, const ProgressCallback& progress)
{
  const std::vector<Id>& parents = this->Pattern->Parents;
  const std::vector<Offset>& begins = this->Pattern->Columns;
  const std::size_t n = parents.size();
  this->Rows.resize(static_cast<std::size_t>(begins.back()));
  this->Entries.resize(static_cast<std::size_t>(begins.back()));
  this->Diagonal.resize(n);
  std::vector<Offset> ends(begins.begin(), begins.end() - 1); // current ends of the columns
  std::vector<double> row(n, 0.0);
  std::vector<Id> mark(n, NoId);
  std::vector<Id> columns(n); // columns of the entries of a row, in topological order
  Offset work = 0;
  for (Id k = 0; k < static_cast<Id>(n); ++k)
  {
    std::size_t first = n;
    mark[k] = k;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(upper, k); entry; ++entry)
    {
      row[entry.row()] += entry.value();
      std::size_t length = 0;
      for (auto i = static_cast<Id>(entry.row()); mark[i] != k; i = parents[i])
      {
        columns[length++] = i;
        mark[i] = k;
      }
      while (length > 0)
      {
        columns[--first] = columns[--length];
      }
    }
    double pivot = row[k];
    row[k] = 0.0;
    for (; first < n; ++first)
    {
      const Id i = columns[first];
      const double value = row[i];
      row[i] = 0.0;
      for (Offset p = begins[i]; p < ends[i]; ++p)
      {
        row[this->Rows[p]] -= this->Entries[p] * value;
      }
      const double entry = value / this->Diagonal[i];
      pivot -= entry * value;
      work += ends[i] - begins[i];
      this->Rows[ends[i]] = k;
      this->Entries[ends[i]++] = entry;
    }
    this->Diagonal[k] = pivot;
    if (pivot == 0.0)
    {
      return InvalidInput("A linear system could not be factorized")
        .Fix("Remove triangles with almost no area");
    }
    if (work > WorkPerReport)
    {
      work = 0;
      DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(k) / static_cast<double>(n)));
    }
  }
  return Status::Success();
}

Id SparseFactor::CountNegative() const
{
  return static_cast<Id>(std::count_if(
    this->Diagonal.begin(), this->Diagonal.end(), [](double pivot) { return pivot < 0.0; }));
}

void SparseFactor::Clear()
{
  this->Rows = std::vector<Id>();
  this->Entries = std::vector<double>();
  this->Diagonal = std::vector<double>();
  this->Computed = false;
  this->Raised = false;
}

template <typename Number>
void SparseFactor::Solve(std::vector<Number>& values) const
{
  const std::vector<Id>& places = this->Pattern->Places;
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
  const Offset* const begin = this->Pattern->Columns.data();
  const Id* const rows = this->Rows.data();
  const double* const entries = this->Entries.data();
  const double* const diagonal = this->Diagonal.data();
  const auto n = static_cast<Id>(this->Diagonal.size());
  for (Id j = 0; j < n; ++j)
  {
    if (!IsZero(values[j])) // mostly zero if there are few sources
    {
      const Number value = values[j];
      for (Offset p = begin[j]; p < begin[j + 1]; ++p)
      {
        values[rows[p]] += value * -entries[p];
      }
      values[j] = value * (1.0 / diagonal[j]);
    }
  }
  for (Id j = n - 1; j >= 0; --j)
  {
    Number value = values[j];
    for (Offset p = begin[j]; p < begin[j + 1]; ++p)
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
