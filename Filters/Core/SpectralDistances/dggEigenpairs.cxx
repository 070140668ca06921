// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggEigenpairs.h"

#include "dggPoissonSystem.h"
#include "dggProgressPart.h"
#include "dggSubMesh.h"

#include <Eigen/Dense>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <new>
#include <numeric>

namespace dgg
{
namespace
{
constexpr double Tolerance = 1e-8;
/// Components with fewer relevant vertices use a dense solver. So do components of up to the second
/// number of vertices if more than a fraction (inverse) of the spectrum is requested.
constexpr Id DenseVertices = 300;
constexpr Id MostDenseVertices = 1000;
constexpr Id DensePart = 5;
/// The basis has 1.5 times as many vectors as requested eigenvalues, plus this number.
constexpr Id MoreVectors = 20;
constexpr int MostIterations = 100;
/// Relative difference between eigenvalues that counts as a gap.
constexpr double Gap = 1e-4;
/// Maximum number of searches for multiple eigenvalues, which one starting vector does not find.
constexpr int MostSearches = 5;
/// Progress after the first search.
constexpr double SearchDone = 0.9;
/// Eigenvalues of the inverse below this fraction of the largest are rounding errors.
constexpr double Rounding = 1e-13;

/// Aborts the loops of Spectra, which offer no other exit. Never propagates out of FindLargest().
struct Aborted
{
};

/// L and M, and the inverse of M^-1/2 L M^-1/2 in the orthogonal complement of its kernel and of
/// the known eigenvectors, with the interface that Spectra requires.
class Operator
{
public:
  using Scalar = double;

  explicit Operator(const PoissonSystem& system)
    : System(system)
    , Roots(system.GetNumberOfVertices())
    , Known(system.GetNumberOfVertices(), 0)
  {
    std::vector<bool> isCounted(system.GetNumberOfComponents(), false);
    for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
    {
      this->Roots[v] = system.IsFixed(v) ? 0.0 : std::sqrt(system.GetArea(v));
      if (this->Roots[v] > 0.0)
      {
        const Id c = system.GetComponent(v);
        ++this->Rank;
        if (system.IsFree(c) && !isCounted[c])
        {
          isCounted[c] = true;
          ++this->Nullity;
        }
      }
    }
    this->Rank -= this->Nullity;
    // Thresholds of Spectra are meant for values of about 1.
    this->Scale = this->Roots.squaredNorm() > 0.0 ? 1.0 / this->Roots.squaredNorm() : 1.0;
  }

  /// Return the number of non-zero eigenvalues, and the multiplicity of 0.
  Id GetRank() const { return this->Rank; }
  Id GetNullity() const { return this->Nullity; }
  /// Returns the factor by which eigenvalues of the inverse are scaled.
  double GetScale() const { return this->Scale; }
  const Eigen::VectorXd& GetRoots() const { return this->Roots; }

  /// Returns true if a dense solver is cheaper for `count` eigenvalues.
  bool IsSmall(Eigen::Index count) const
  {
    return this->Rank <= DenseVertices || count >= this->Rank ||
      (this->Rank <= MostDenseVertices && count > this->Rank / DensePart);
  }

  void SetKnown(const Eigen::MatrixXd& vectors) { this->Known = vectors; }
  /// Sets a callback that receives the number of applications, counted from now on.
  void SetProgress(const std::function<bool(Id)>& progress)
  {
    this->Applied = 0;
    this->Progress = progress;
  }

  Eigen::Index rows() const { return this->Roots.size(); }
  Eigen::Index cols() const { return this->Roots.size(); }
  void perform_op(const double* x, double* y) const
  {
    if (this->Progress && !this->Progress(this->Applied++))
    {
      throw Aborted();
    }
    const Eigen::Index n = this->rows();
    Eigen::Map<const Eigen::VectorXd> from(x, n);
    Eigen::Map<Eigen::VectorXd> to(y, n);
    std::vector<double> values(n);
    Eigen::Map<Eigen::VectorXd> inner(values.data(), n);
    inner = this->Off(from).cwiseProduct(this->Roots);
    this->System.Solve(values);
    to = this->Off(this->Scale * inner.cwiseProduct(this->Roots));
  }

  /// Returns the number of eigenvalues of L v = lambda M v below sigma, including 0; -1 if it
  /// cannot be determined, or if `progress` returns false.
  Id CountBelow(double sigma, const ProgressCallback& progress) const
  {
    Eigen::SparseMatrix<double> matrix = this->System.GetStiffness();
    for (int column = 0; column < matrix.cols(); ++column)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
      {
        const bool isDiagonal = entry.row() == column;
        if (!(this->Roots[column] > 0.0) || !(this->Roots[entry.row()] > 0.0))
        {
          entry.valueRef() = isDiagonal ? 1.0 : 0.0;
        }
        else if (isDiagonal)
        {
          entry.valueRef() -= sigma * this->Roots[column] * this->Roots[column];
        }
      }
    }
    SparseFactor factor;
    const Status status = factor.Compute(this->System.GetOrder(), matrix, {}, progress);
    return status.IsOk() && !factor.IsRaised() ? factor.CountNegative() : -1;
  }

private:
  /// Projects a vector onto the orthogonal complement of the known vectors.
  Eigen::VectorXd Off(const Eigen::VectorXd& x) const
  {
    return x - this->Known * (this->Known.transpose() * x);
  }

  const PoissonSystem& System;
  Eigen::VectorXd Roots;
  Eigen::MatrixXd Known;
  double Scale = 1.0;
  Id Rank = 0;
  Id Nullity = 0;
  std::function<bool(Id)> Progress;
  mutable Id Applied = 0;
};

/// Stores eigenvalues of L v = lambda M v, increasing, and eigenvectors, given M^1/2 v.
void Put(const Operator& op, const Eigen::VectorXd& values, const Eigen::MatrixXd& vectors,
  Eigenpairs& pairs)
{
  const Eigen::VectorXd& roots = op.GetRoots();
  const Eigen::Index n = roots.size();
  pairs.Values.assign(values.data(), values.data() + values.size());
  pairs.Functions.assign(static_cast<std::size_t>(n * values.size()), 0.0);
  for (Eigen::Index k = 0; k < values.size(); ++k)
  {
    double* function = pairs.Functions.data() + k * n;
    // The sign is normalized by the first value that is not small.
    double largest = 0.0;
    for (Eigen::Index v = 0; v < n; ++v)
    {
      function[v] = roots[v] > 0.0 ? vectors(v, k) / roots[v] : 0.0;
      largest = std::max(largest, std::abs(function[v]));
    }
    Eigen::Index first = 0;
    while (first < n - 1 && !(std::abs(function[first]) > 0.1 * largest))
    {
      ++first;
    }
    if (function[first] < 0.0)
    {
      std::transform(function, function + n, function, [](double x) { return -x; });
    }
  }
}

/// Returns how many of the largest eigenvalues of the inverse exceed rounding errors. The others
/// belong to practically infinite eigenvalues and may have any sign.
Eigen::Index CountDefinite(const Eigen::VectorXd& inverses)
{
  Eigen::Index count = 0;
  while (count < inverses.size() && inverses[count] > Rounding * inverses[0])
  {
    ++count;
  }
  return count;
}

/// Returns the dense inverse. Its largest eigenvalues are accurate, whereas the smallest ones of
/// the matrix itself are not if its entries differ widely in magnitude.
Eigen::MatrixXd MakeInverse(const Operator& op)
{
  const Eigen::Index n = op.rows();
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k)
  {
    if (op.GetRoots()[k] > 0.0)
    {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(n, k);
      op.perform_op(unit.data(), inverse.col(k).data());
    }
  }
  return 0.5 * (inverse + inverse.transpose());
}

/// Adds the largest eigenvalues of the inverse in the complement of the known vectors, in
/// decreasing order.
Status FindLargest(Operator& op, Eigen::Index count, int search, const ProgressCallback& progress,
  Eigen::VectorXd& values, Eigen::MatrixXd& vectors)
{
  Eigen::VectorXd newValues;
  Eigen::MatrixXd newVectors;
  const Eigen::Index n = op.rows();
  const bool isDense = op.IsSmall(count);
  const auto size = std::min<Eigen::Index>(op.GetRank(), count + count / 2 + MoreVectors);
  const auto expected = static_cast<double>(isDense ? n : size + size / 2);
  op.SetProgress([&](Id applied) {
    return ShouldContinue(progress, SearchDone * std::min(1.0, applied / expected));
  });
  try
  {
    if (isDense)
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(MakeInverse(op));
      newValues = solver.eigenvalues().tail(count).reverse();
      newVectors = solver.eigenvectors().rightCols(count).rowwise().reverse();
    }
    else
    {
      Spectra::SymEigsSolver<Operator> solver(op, count, size);
      solver.init(Spectra::SimpleRandom<double>(search).random_vec(n).data());
      solver.compute(Spectra::SortRule::LargestAlge, MostIterations, Tolerance);
      newValues = solver.eigenvalues();
      newVectors = solver.eigenvectors();
    }
  }
  catch (const Aborted&)
  {
    return Status::Abort();
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception&)
  {
    return InvalidInput("The eigenvalues could not be computed").Fix("Improve the triangles");
  }
  // Merged with the known ones, in order.
  const Eigen::Index known = values.size();
  std::vector<Eigen::Index> order(known + newValues.size());
  std::iota(order.begin(), order.end(), 0);
  const auto valueOf = [&](Eigen::Index k) { return k < known ? values[k] : newValues[k - known]; };
  std::stable_sort(order.begin(), order.end(),
    [&](Eigen::Index a, Eigen::Index b) { return valueOf(a) > valueOf(b); });
  Eigen::VectorXd allValues(order.size());
  Eigen::MatrixXd allVectors(n, order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    const Eigen::Index from = order[k];
    allValues[k] = valueOf(from);
    allVectors.col(k) = from < known ? vectors.col(from) : newVectors.col(from - known);
  }
  values.swap(allValues);
  vectors.swap(allVectors);
  return Status::Success();
}

/// Finds eigenpairs of a system with one component.
Status FindOnComponent(
  const PoissonSystem& system, Id count, const ProgressCallback& progress, Eigenpairs& pairs)
{
  Operator op(system);
  count = std::min(count, op.GetRank());
  DGG_RETURN_IF_ERROR(ReportTo(progress, 0.0));
  if (count == 0)
  {
    pairs.IsComplete = true;
    return Status::Success();
  }
  // One more than requested, to detect the gap behind the last one.
  const auto wanted = static_cast<Id>(std::min<Eigen::Index>(count + 1, op.GetRank()));
  const bool isDense = op.IsSmall(wanted);
  Eigen::VectorXd inverses;
  Eigen::MatrixXd vectors;
  Status status = FindLargest(op, wanted, 0, progress, inverses, vectors);
  const auto valueOf = [&](Eigen::Index k) { return op.GetScale() / inverses[k]; };
  pairs.IsComplete = isDense;
  if (status.IsOk() && !isDense && CountDefinite(inverses) > 0)
  {
    Eigen::Index gap = CountDefinite(inverses) - 1;
    while (gap > 0 && !(valueOf(gap) > valueOf(gap - 1) * (1.0 + Gap)))
    {
      --gap;
    }
    const double sigma = 0.5 * (gap > 0 ? valueOf(gap - 1) + valueOf(gap) : valueOf(0));
    const auto more = [&](double) { return ShouldContinue(progress, SearchDone); };
    const Id below = op.CountBelow(sigma, more) - op.GetNullity();
    for (int search = 1; gap < below && search < MostSearches && status.IsOk(); ++search)
    {
      op.SetKnown(vectors);
      status = FindLargest(op, below - gap, search, more, inverses, vectors);
      gap = 0;
      while (gap < CountDefinite(inverses) && valueOf(gap) < sigma)
      {
        ++gap;
      }
    }
    pairs.IsComplete = gap == below;
  }
  if (status.IsOk())
  {
    const Eigen::Index kept = std::min<Eigen::Index>(count, CountDefinite(inverses));
    Put(op, op.GetScale() * inverses.head(kept).cwiseInverse(), vectors.leftCols(kept), pairs);
  }
  return !status.IsOk() || ShouldContinue(progress, 1.0) ? status : Status::Abort();
}

/// Returns the options for a submesh with the given vertices of the parent.
PoissonOptions OptionsOf(const PoissonSystem& system, const std::vector<Id>& vertices)
{
  PoissonOptions options = system.GetOptions();
  options.DirichletVertices.clear();
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    if (system.IsFixed(vertices[k]))
    {
      options.DirichletVertices.push_back(static_cast<Id>(k));
    }
  }
  return options;
}
}

Status FindEigenpairs(const PoissonSolver& solver, Id count, const ProgressCallback& progress,
  std::vector<Eigenpairs>& pairs, const std::vector<bool>& isWanted)
{
  pairs.clear();
  if (!solver.IsReady())
  {
    return InvalidInput("The solver has not been prepared").Fix("Call Prepare() first");
  }
  if (count < 1)
  {
    return InvalidValue("NumberOfEigenvalues", count).Fix("Use a number of at least 1");
  }
  const PoissonSystem& system = solver.GetSystem();
  const SurfaceMesh& mesh = system.GetMesh();
  std::vector<std::vector<Id>> parts = FindComponentFaces(mesh);
  FaceSelector selector(mesh);
  std::vector<Eigenpairs> found(static_cast<std::size_t>(system.GetNumberOfComponents()));
  double done = 0.0;
  for (std::vector<Id>& faces : parts)
  {
    const Id c = system.GetComponent(mesh.Origin(3 * faces[0]));
    const double size = static_cast<double>(faces.size()) / mesh.GetNumberOfFaces();
    const ProgressCallback reported = ProgressPart(progress, done, done + size);
    done += size;
    if (!isWanted.empty() && !isWanted[c])
    {
      continue;
    }
    if (parts.size() == 1)
    {
      DGG_RETURN_IF_ERROR(FindOnComponent(system, count, reported, found[c]));
      found[c].Vertices.resize(static_cast<std::size_t>(mesh.GetNumberOfVertices()));
      std::iota(found[c].Vertices.begin(), found[c].Vertices.end(), 0);
    }
    else if (!system.IsThin(c))
    {
      SurfaceMesh component;
      std::vector<Id> vertices;
      {
        const SubMesh part = selector.Select(faces);
        DGG_RETURN_IF_ERROR(part.Build(mesh, component));
        for (const SurfacePoint& point : part.Points)
        {
          vertices.push_back(point.Vertex);
        }
      }
      PoissonSystem own(component);
      DGG_RETURN_IF_ERROR(own.Analyze(OptionsOf(system, vertices), nullptr));
      DGG_RETURN_IF_ERROR(own.Factorize());
      DGG_RETURN_IF_ERROR(FindOnComponent(own, count, reported, found[c]));
      found[c].Vertices.swap(vertices);
    }
  }
  pairs.swap(found);
  return ReportTo(progress, 1.0);
}
}
