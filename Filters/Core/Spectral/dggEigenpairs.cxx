// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggEigenpairs.h"

#include "dggPoissonSystem.h"
#include "dggProgressPart.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

namespace dgg
{
namespace
{
constexpr int Block = SparseLanes::SizeAtCompileTime;
constexpr double Tolerance = 1e-8;
/// Meshes with fewer vertices that count are left to a dense solver.
constexpr Id DenseVertices = 300;
/// Up to so many vertices, so are requests for more than a part of the spectrum.
constexpr Id MostDenseVertices = 1000;
constexpr Id DensePart = 5;
/// Relative difference of eigenvalues that makes a gap.
constexpr double Gap = 1e-4;
constexpr int MostRestarts = 4;
/// Values that are asked for at first of a component, besides those that its area lets expect, and
/// the part of the progress that takes.
constexpr double LeastWanted = 8.0;
constexpr double FirstPassDone = 0.9;
/// Eigenvalues of the inverse below this part of the largest are rounding.
constexpr double Rounding = 1e-13;

bool Goes(const ProgressCallback& progress, double fraction)
{
  return !progress || progress(std::min(1.0, fraction));
}

/// L and M, and the inverse of M^-1/2 L M^-1/2 off its kernel.
class Operator
{
public:
  explicit Operator(const PoissonSystem& system)
    : System(system)
    , Roots(system.GetNumberOfVertices())
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
  }

  /// How many eigenvalues there are besides 0, and how often that is one.
  Id GetRank() const { return this->Rank; }
  Id GetNullity() const { return this->Nullity; }
  Offset GetSolved() const { return this->Solved; }
  const Eigen::VectorXd& GetRoots() const { return this->Roots; }
  const PoissonSystem& GetSystem() const { return this->System; }

  Eigen::MatrixXd Apply(const Eigen::MatrixXd& x) const
  {
    const Id n = this->System.GetNumberOfVertices();
    std::vector<SparseLanes> values(n, SparseLanes(SparseLanes::Zero()));
    for (Id v = 0; v < n; ++v)
    {
      for (int k = 0; k < x.cols(); ++k)
      {
        values[v][k] = x(v, k) * this->Roots[v];
      }
    }
    this->System.Solve(values);
    this->Solved += static_cast<Offset>(n) * x.cols();
    Eigen::MatrixXd result(n, x.cols());
    for (Id v = 0; v < n; ++v)
    {
      for (int k = 0; k < x.cols(); ++k)
      {
        result(v, k) = values[v][k] * this->Roots[v];
      }
    }
    return result;
  }

  /// How many eigenvalues of L v = lambda M v are below sigma, 0 included; -1 when that cannot be
  /// told.
  Id CountBelow(double sigma) const
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
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    if (factor.info() != Eigen::Success)
    {
      return -1;
    }
    return static_cast<Id>((factor.vectorD().array() < 0.0).count());
  }

private:
  const PoissonSystem& System;
  Eigen::VectorXd Roots;
  Id Rank = 0;
  Id Nullity = 0;
  mutable Offset Solved = 0;
};

/// An orthonormal basis that grows, and the operator on it.
class Krylov
{
public:
  explicit Krylov(const Operator& op)
    : Op(op)
    , Generator(1)
  {
  }

  /// Directions that may not have been seen yet.
  void AddRandom()
  {
    Eigen::MatrixXd x(this->Op.GetRoots().size(), Block);
    for (Eigen::Index k = 0; k < x.size(); ++k)
    {
      x.data()[k] = static_cast<double>(this->Generator() >> 11) * 0x1.0p-52 - 1.0;
    }
    this->Last = this->Orthonormal(this->Op.Apply(x));
    this->Coupling.resize(0, 0);
  }

  /// Apply the operator to what was added last. False when there is nothing new to look at.
  bool Grow()
  {
    const Eigen::Index size = this->Size;
    const Eigen::Index added = this->Last.cols();
    if (added == 0)
    {
      return false;
    }
    if (this->Basis.cols() < size + added)
    {
      this->Basis.conservativeResize(
        this->Last.rows(), std::max<Eigen::Index>(2 * this->Basis.cols(), size + 8 * Block));
    }
    this->Basis.middleCols(size, added) = this->Last;
    this->Size += added;
    const Eigen::MatrixXd image = this->Op.Apply(this->Last);
    const Eigen::MatrixXd column = this->Basis.leftCols(this->Size).transpose() * image;
    this->Projection.conservativeResizeLike(Eigen::MatrixXd::Zero(this->Size, this->Size));
    this->Projection.rightCols(added) = column;
    this->Projection.bottomRows(added) = column.transpose();
    this->Scale = std::max(this->Scale, column.cwiseAbs().maxCoeff());
    const Eigen::MatrixXd rest = this->Project(image);
    this->LastAdded = added;
    this->Last = this->Orthonormal(rest);
    this->Coupling = this->Last.transpose() * rest;
    return true;
  }

  /// Ritz values, the largest first, and how far the pairs are from being eigenpairs.
  void Solve()
  {
    const Eigen::MatrixXd symmetric = 0.5 * (this->Projection + this->Projection.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
    this->Values = solver.eigenvalues().reverse();
    this->Vectors = solver.eigenvectors().rowwise().reverse();
    this->Residuals = Eigen::VectorXd::Zero(this->Size);
    if (this->Coupling.rows() > 0)
    {
      this->Residuals =
        (this->Coupling * this->Vectors.bottomRows(this->LastAdded)).colwise().norm().transpose();
    }
  }

  Eigen::Index GetSize() const { return this->Size; }
  const Eigen::VectorXd& GetValues() const { return this->Values; }
  const Eigen::VectorXd& GetResiduals() const { return this->Residuals; }
  Eigen::MatrixXd GetVectors(Eigen::Index count) const
  {
    return this->Basis.leftCols(this->Size) * this->Vectors.leftCols(count);
  }

private:
  /// What is orthogonal to the basis.
  Eigen::MatrixXd Project(const Eigen::MatrixXd& columns) const
  {
    if (this->Size == 0)
    {
      return columns;
    }
    const auto basis = this->Basis.leftCols(this->Size);
    return columns - basis * (basis.transpose() * columns);
  }

  /// An orthonormal basis of the columns, orthogonal to what there is; those that add nothing are
  /// left out. Twice is enough (Parlett, "The symmetric eigenvalue problem", 1980).
  Eigen::MatrixXd Orthonormal(const Eigen::MatrixXd& columns) const
  {
    Eigen::MatrixXd result = columns;
    for (int pass = 0; pass < 2; ++pass)
    {
      result = this->Project(result);
      Eigen::Index kept = 0;
      for (Eigen::Index k = 0; k < result.cols(); ++k)
      {
        Eigen::VectorXd x = result.col(k);
        const double before = x.norm();
        for (int again = 0; again < 2; ++again)
        {
          x -= result.leftCols(kept) * (result.leftCols(kept).transpose() * x);
        }
        const double after = x.norm();
        const double least = pass == 0 ? 1e-13 * this->Scale : 0.5;
        if (after > least && after > 1e-10 * before && after > 0.0)
        {
          result.col(kept++) = x / after;
        }
      }
      result.conservativeResize(Eigen::NoChange, kept);
    }
    return result;
  }

  const Operator& Op;
  std::mt19937_64 Generator;
  Eigen::Index Size = 0;
  Eigen::Index LastAdded = 0;
  double Scale = 0.0;
  Eigen::MatrixXd Basis;
  Eigen::MatrixXd Last;
  Eigen::MatrixXd Coupling;
  Eigen::MatrixXd Projection;
  Eigen::VectorXd Values;
  Eigen::MatrixXd Vectors;
  Eigen::VectorXd Residuals;
};

/// Eigenvalues of L v = lambda M v, increasing, and M^1/2 v.
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
    // The sign is that of the first value that is not small.
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

/// How many of the largest eigenvalues of the inverse stand out of rounding. Those below belong to
/// eigenvalues that are as good as infinite: they can have any sign.
Eigen::Index CountDefinite(const Eigen::VectorXd& inverses)
{
  Eigen::Index count = 0;
  while (count < inverses.size() && inverses[count] > Rounding * inverses[0])
  {
    ++count;
  }
  return count;
}

/// A component of a mesh as a mesh of its own.
struct MeshPart
{
  std::vector<Id> Vertices; // of the whole
  std::vector<Id> Faces;
};

/// The components that have faces. Places are those of vertices in their component.
std::vector<MeshPart> FindParts(const PoissonSystem& system, std::vector<Id>& places)
{
  const SurfaceMesh& mesh = system.GetMesh();
  std::vector<MeshPart> parts(static_cast<std::size_t>(system.GetNumberOfComponents()));
  places.resize(static_cast<std::size_t>(mesh.GetNumberOfVertices()));
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    std::vector<Id>& vertices = parts[system.GetComponent(v)].Vertices;
    places[v] = static_cast<Id>(vertices.size());
    vertices.push_back(v);
  }
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (!mesh.IsDropped(f))
    {
      parts[system.GetComponent(mesh.Origin(3 * f))].Faces.push_back(f);
    }
  }
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                [](const MeshPart& part) { return part.Faces.empty(); }),
    parts.end());
  return parts;
}

Status BuildPart(const SurfaceMesh& mesh, const MeshPart& part, const std::vector<Id>& places,
  std::vector<Id>& placeOfFace, SurfaceMesh& result)
{
  std::vector<Id> triangles;
  std::vector<double> lengths;
  std::vector<Id> twins;
  for (std::size_t k = 0; k < part.Faces.size(); ++k)
  {
    placeOfFace[part.Faces[k]] = static_cast<Id>(k);
  }
  for (const Id f : part.Faces)
  {
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Id twin = mesh.Twin(h);
      triangles.push_back(places[mesh.Origin(h)]);
      lengths.push_back(mesh.Length(h));
      twins.push_back(twin == NoId ? NoId : 3 * placeOfFace[SurfaceMesh::Face(twin)] + twin % 3);
    }
  }
  return SurfaceMesh::FromGluedLengths(static_cast<Offset>(part.Vertices.size()), triangles.data(),
    static_cast<Offset>(part.Faces.size()), lengths.data(), twins.data(), result,
    { &mesh, part.Faces.data() });
}

/// All of the inverse, of which the largest eigenvalues are accurate, as those of the matrix itself
/// are not where it has entries of very different size.
Status SolveDense(const Operator& op, Id count, const ProgressCallback& progress, Eigenpairs& pairs)
{
  const Eigen::VectorXd& roots = op.GetRoots();
  std::vector<Eigen::Index> active;
  for (Eigen::Index v = 0; v < roots.size(); ++v)
  {
    if (roots[v] > 0.0)
    {
      active.push_back(v);
    }
  }
  const auto size = static_cast<Eigen::Index>(active.size());
  Eigen::MatrixXd inverse(size, size);
  for (Eigen::Index first = 0; first < size; first += Block)
  {
    if (!Goes(progress, 0.5 * static_cast<double>(first) / static_cast<double>(size)))
    {
      return Status::Abort();
    }
    const Eigen::Index width = std::min<Eigen::Index>(Block, size - first);
    Eigen::MatrixXd units = Eigen::MatrixXd::Zero(roots.size(), width);
    for (Eigen::Index k = 0; k < width; ++k)
    {
      units(active[first + k], k) = 1.0;
    }
    const Eigen::MatrixXd columns = op.Apply(units);
    for (Eigen::Index i = 0; i < size; ++i)
    {
      inverse.block(i, first, 1, width) = columns.row(active[i]);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
    0.5 * (inverse + inverse.transpose()));
  const Eigen::VectorXd inverses = solver.eigenvalues().reverse();
  const Eigen::Index kept = std::min<Eigen::Index>(count, CountDefinite(inverses));
  Eigen::MatrixXd vectors = Eigen::MatrixXd::Zero(roots.size(), kept);
  for (Eigen::Index i = 0; i < size; ++i)
  {
    for (Eigen::Index k = 0; k < kept; ++k)
    {
      vectors(active[i], k) = solver.eigenvectors()(i, size - 1 - k);
    }
  }
  Put(op, inverses.head(kept).cwiseInverse(), vectors, pairs);
  pairs.IsComplete = true;
  return Goes(progress, 1.0) ? Status::Success() : Status::Abort();
}

/// As if the mesh was connected.
Status FindAllAtOnce(
  const PoissonSystem& system, Id count, const ProgressCallback& progress, Eigenpairs& pairs)
{
  const Operator op(system);
  count = std::min(count, op.GetRank());
  if (count == 0)
  {
    pairs.IsComplete = true;
    return Status::Success();
  }
  if (!Goes(progress, 0.0))
  {
    return Status::Abort();
  }
  if (op.GetRank() <= DenseVertices ||
    (op.GetRank() <= MostDenseVertices && count > op.GetRank() / DensePart))
  {
    const Status status = SolveDense(op, count, progress, pairs);
    pairs.Solved = op.GetSolved();
    return status;
  }
  Krylov krylov(op);
  krylov.AddRandom();
  // One more than asked for, to see the gap behind the last one.
  const Eigen::Index wanted = std::min(count + 1, op.GetRank());
  for (int restart = 0; restart <= MostRestarts; ++restart)
  {
    Eigen::Index converged = 0;
    Eigen::Index next = wanted + wanted / 2 + Block;
    while (krylov.Grow())
    {
      if (!Goes(progress,
            std::min(0.9,
              0.9 * static_cast<double>(krylov.GetSize()) /
                (2.5 * static_cast<double>(wanted) + 4.0 * Block))))
      {
        return Status::Abort();
      }
      if (krylov.GetSize() < next && krylov.GetSize() < op.GetRank())
      {
        continue;
      }
      next = krylov.GetSize() + std::max<Eigen::Index>(2 * Block, wanted / 8);
      krylov.Solve();
      converged = 0;
      while (converged < wanted &&
        krylov.GetResiduals()[converged] <= Tolerance * krylov.GetValues()[converged])
      {
        ++converged;
      }
      if (converged == wanted)
      {
        break;
      }
    }
    if (converged < wanted)
    {
      krylov.Solve(); // the space is exhausted
    }
    const Eigen::Index found = std::min<Eigen::Index>(wanted, CountDefinite(krylov.GetValues()));
    if (found == 0)
    {
      break;
    }
    const Eigen::VectorXd values = krylov.GetValues().head(found).cwiseInverse();
    Eigen::Index gap = found - 1;
    while (gap > 0 && !(values[gap] > values[gap - 1] * (1.0 + Gap)))
    {
      --gap;
    }
    const double sigma = gap > 0 ? 0.5 * (values[gap - 1] + values[gap]) : 0.5 * values[0];
    const Id below = op.CountBelow(sigma);
    pairs.IsComplete = below == static_cast<Id>(gap) + op.GetNullity();
    if (pairs.IsComplete || below < 0 || restart == MostRestarts)
    {
      const bool isComplete = pairs.IsComplete;
      const Eigen::Index kept = std::min<Eigen::Index>(found, count);
      Put(op, values.head(kept), krylov.GetVectors(kept), pairs);
      pairs.IsComplete = isComplete;
      break;
    }
    krylov.AddRandom();
  }
  pairs.Solved = op.GetSolved();
  return Goes(progress, 1.0) ? Status::Success() : Status::Abort();
}

/// The options for a part.
PoissonOptions OptionsOf(const PoissonSystem& system, const MeshPart& part)
{
  PoissonOptions options = system.GetOptions();
  options.GivenVertices.clear();
  for (std::size_t k = 0; k < part.Vertices.size(); ++k)
  {
    if (system.IsFixed(part.Vertices[k]))
    {
      options.GivenVertices.push_back(static_cast<Id>(k));
    }
  }
  return options;
}

/// The largest of the values that would be taken of those found; Infinity where there are too few.
double FindLimit(const std::vector<Eigenpairs>& found, Id count)
{
  std::vector<double> values;
  for (const Eigenpairs& of : found)
  {
    values.insert(values.end(), of.Values.begin(), of.Values.end());
  }
  if (values.size() < static_cast<std::size_t>(count))
  {
    return Infinity;
  }
  std::nth_element(values.begin(), values.begin() + (count - 1), values.end());
  return values[count - 1];
}

/// Of all parts, the smallest values.
void Merge(const std::vector<MeshPart>& parts, const std::vector<Eigenpairs>& found, Id count,
  std::size_t numberOfVertices, Eigenpairs& pairs)
{
  struct Place
  {
    double Value;
    std::size_t Part;
    std::size_t Index;
  };
  std::vector<Place> order;
  pairs.IsComplete = true;
  for (std::size_t p = 0; p < found.size(); ++p)
  {
    pairs.IsComplete = pairs.IsComplete && found[p].IsComplete;
    for (std::size_t k = 0; k < found[p].Values.size(); ++k)
    {
      order.push_back({ found[p].Values[k], p, k });
    }
  }
  std::stable_sort(
    order.begin(), order.end(), [](const Place& a, const Place& b) { return a.Value < b.Value; });
  order.resize(std::min(order.size(), static_cast<std::size_t>(count)));
  pairs.Functions.assign(order.size() * numberOfVertices, 0.0);
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    const std::vector<Id>& vertices = parts[order[k].Part].Vertices;
    const double* const values =
      found[order[k].Part].Functions.data() + order[k].Index * vertices.size();
    pairs.Values.push_back(order[k].Value);
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      pairs.Functions[k * numberOfVertices + vertices[i]] = values[i];
    }
  }
}
}

Status FindEigenpairs(
  const PoissonSolver& solver, Id count, const ProgressCallback& progress, Eigenpairs& pairs)
{
  pairs = Eigenpairs();
  if (!solver.IsReady())
  {
    return Status::Invalid("the solver has not been prepared: call Prepare() first");
  }
  if (count < 1)
  {
    return Status::Invalid("the number of eigenvalues must be positive");
  }
  const PoissonSystem& system = solver.GetSystem();
  std::vector<Id> places;
  const std::vector<MeshPart> parts = FindParts(system, places);
  if (parts.size() < 2)
  {
    return FindAllAtOnce(system, count, progress, pairs);
  }
  const SurfaceMesh& mesh = system.GetMesh();
  const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
  std::vector<Id> placeOfFace(static_cast<std::size_t>(mesh.GetNumberOfFaces()), NoId);
  std::vector<Eigenpairs> found(parts.size());
  const auto findOf = [&](std::size_t p, Id wanted, const ProgressCallback& told) {
    SurfaceMesh part;
    Status status = BuildPart(mesh, parts[p], places, placeOfFace, part);
    PoissonSystem own(part);
    status = status.IsOk() ? own.Analyze(OptionsOf(system, parts[p]), nullptr) : status;
    status = status.IsOk() ? own.Factorize() : status;
    status = status.IsOk() ? FindAllAtOnce(own, wanted, told, found[p]) : status;
    pairs.Solved += found[p].Solved;
    return status;
  };
  // As many as the part should have by its area (Weyl's law), then more where the last one is not
  // too large. Nothing is asked for where triangles are too thin.
  const std::vector<double>& areas = system.GetAreas();
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  std::vector<Id> wanted(parts.size(), 0);
  double limit = Infinity;
  double done = 0.0;
  bool isMore = true;
  for (bool isFirst = true; isMore; isFirst = false)
  {
    isMore = false;
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      const Id c = system.GetComponent(parts[p].Vertices[0]);
      const bool hasAll = found[p].GetCount() < wanted[p] || wanted[p] >= count;
      if (system.IsThin(c) || (!isFirst && (hasAll || found[p].Values.back() > limit)))
      {
        continue;
      }
      const double share = 2.0 * count * system.GetComponentArea(c) / area;
      wanted[p] = isFirst ? static_cast<Id>(std::min<double>(count, LeastWanted + share))
                          : std::min(count, 4 * wanted[p]);
      const auto size = static_cast<double>(parts[p].Vertices.size());
      const double end = isFirst ? done + FirstPassDone * size / static_cast<double>(n) : done;
      Status status = findOf(p, wanted[p], ProgressPart(progress, done, end));
      if (!status.IsOk())
      {
        return status;
      }
      done = end;
      isMore = true;
    }
    limit = FindLimit(found, count);
  }
  Merge(parts, found, count, n, pairs);
  return Goes(progress, 1.0) ? Status::Success() : Status::Abort();
}
}
