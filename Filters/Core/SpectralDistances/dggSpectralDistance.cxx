// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSpectralDistance.h"

#include "dggBlockLoop.h"
#include "dggGeodesicSource.h"
#include "dggGreensColumn.h"
#include "dggPoissonSystem.h"
#include "dggProgressPart.h"
#include "dggThinTriangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace dgg
{
namespace
{
/// Number of vertices solved together for the diagonal.
constexpr Offset BlockSize = SparseLanes::SizeAtCompileTime;
/// Progress after the solves of distances between points.
constexpr double SolvesDone = 0.9;
/// Approximate number of values per block of points: some milliseconds. Larger points form blocks
/// of their own.
constexpr double NumbersPerBlock = 1e6;

/// Returns the number of points per block if each processes `numbers` values.
Offset BlockOf(double numbers)
{
  return static_cast<Offset>(std::max(1.0, NumbersPerBlock / std::max(1.0, numbers)));
}

/// Returns the root of a square, which may be slightly negative by rounding.
double Root(double square)
{
  return std::sqrt(std::max(0.0, square));
}
}

SpectralDistance::SpectralDistance(const PoissonSolver& solver)
  : Solver(solver)
{
}

Status SpectralDistance::Prepare(const SpectralOptions& options, const ParallelFor& parallel,
  const ProgressCallback& progress, const std::vector<SurfacePoint>& sources)
{
  if (!this->Solver.IsReady())
  {
    return InvalidInput("The solver has not been prepared").Fix("Call Prepare() first");
  }
  if (!(options.Time >= 0.0) || !(options.Time < Infinity))
  {
    return InvalidValue("DiffusionTime", options.Time).Fix("Use a finite number of at least 0");
  }
  const bool isExact = options.Method == SpectralMethod::Exact;
  if (options.Kind == SpectralKind::Diffusion && isExact)
  {
    return InvalidInput("Diffusion distances need eigenvalues")
      .At("Method")
      .Fix("Set {Method} to Spectrum");
  }
  const std::uint64_t revision = this->Solver.GetSystem().GetRevision();
  const bool isSameSystem = this->IsPrepared && this->Revision == revision;
  const bool hasSpectrum = isSameSystem && !isExact &&
    this->Options.Method == SpectralMethod::Spectrum &&
    this->Options.NumberOfEigenvalues == options.NumberOfEigenvalues;
  const bool hasDiagonal = isSameSystem && isExact &&
    this->Options.Method == SpectralMethod::Exact && this->Options.Kind == options.Kind;
  this->IsPrepared = false;
  this->Options = options;
  Status status;
  if (!hasSpectrum)
  {
    this->Pairs.clear();
  }
  if (!hasDiagonal)
  {
    this->Diagonal.clear();
  }
  if (isExact && !hasDiagonal)
  {
    status = this->FindDiagonal(parallel, progress);
  }
  if (!isExact)
  {
    status = this->FindPairs(sources, progress);
  }
  this->IsPrepared = status.IsOk();
  this->Revision = revision;
  return status;
}

/// Adds the eigenpairs of components that have none yet.
Status SpectralDistance::FindPairs(
  const std::vector<SurfacePoint>& sources, const ProgressCallback& progress)
{
  const PoissonSystem& system = this->Solver.GetSystem();
  this->Pairs.resize(static_cast<std::size_t>(system.GetNumberOfComponents()));
  this->Places.resize(this->Solver.GetAreas().size(), NoId);
  std::vector<bool> isWanted(this->Pairs.size(), sources.empty());
  for (const SurfacePoint& source : sources)
  {
    isWanted[system.GetComponent(source)] = true;
  }
  for (std::size_t c = 0; c < isWanted.size(); ++c)
  {
    isWanted[c] = isWanted[c] && this->Pairs[c].Vertices.empty();
  }
  std::vector<Eigenpairs> found;
  DGG_RETURN_IF_ERROR(
    FindEigenpairs(this->Solver, this->Options.NumberOfEigenvalues, progress, found, isWanted));
  bool isNew = false;
  for (std::size_t c = 0; c < found.size(); ++c)
  {
    for (std::size_t i = 0; i < found[c].Vertices.size(); ++i)
    {
      this->Places[found[c].Vertices[i]] = static_cast<Id>(i);
    }
    if (!found[c].Vertices.empty())
    {
      this->Pairs[c] = std::move(found[c]);
      isNew = true;
    }
  }
  this->NumberOfSpectra += isNew ? 1 : 0;
  return Status::Success();
}

double SpectralDistance::Filter(const Eigenpairs& pairs, std::size_t k) const
{
  const double eigenvalue = pairs.Values[k];
  switch (this->Options.Kind)
  {
    case SpectralKind::Biharmonic:
      return 1.0 / (eigenvalue * eigenvalue);
    case SpectralKind::CommuteTime:
      return 1.0 / eigenvalue;
    case SpectralKind::Diffusion:
      break;
  }
  const double time = this->Options.Time > 0.0 ? this->Options.Time : 0.1 / pairs.Values.front();
  return std::exp(-2.0 * time * eigenvalue);
}

Status SpectralDistance::CheckPrepared() const
{
  if (!this->IsPrepared)
  {
    return InvalidInput("The distance has not been prepared").Fix("Call Prepare() first");
  }
  if (this->Revision != this->Solver.GetSystem().GetRevision() || !this->Solver.IsReady())
  {
    return InvalidInput("The solver has since been prepared with other options")
      .Fix("Call Prepare() again");
  }
  return Status::Success();
}

Status SpectralDistance::CheckPlace(const SurfacePoint& point) const
{
  if (!this->Solver.IsReady())
  {
    return InvalidInput("The solver has not been prepared").Fix("Call Prepare() first");
  }
  return this->Solver.CheckPlace(point);
}

Status SpectralDistance::CheckSource(const SurfacePoint& point) const
{
  DGG_RETURN_IF_ERROR(this->CheckPlace(point));
  const PoissonSystem& system = this->Solver.GetSystem();
  return CheckThinPlace(system, system.GetComponent(point), NameOf(point));
}

Status SpectralDistance::CheckPreparedSource(const SurfacePoint& point) const
{
  DGG_RETURN_IF_ERROR(this->CheckSource(point));
  const bool isReady = this->Options.Method == SpectralMethod::Exact ||
    !this->Pairs[this->Solver.GetSystem().GetComponent(point)].Vertices.empty();
  return isReady ? Status::Success()
                 : InvalidInput("The component of ", NameOf(point), " has no eigenpairs")
                     .Fix("Call Prepare() with this source");
}

/// Returns a unit load at a point, 0 at given values.
std::vector<double> SpectralDistance::LoadOf(const SurfacePoint& point) const
{
  const PoissonSystem& system = this->Solver.GetSystem();
  std::vector<double> load(system.GetNumberOfVertices(), 0.0);
  ForEachCornerAround(system.GetMesh(), point,
    [&](Id v, double weight, double) { load[v] += system.IsFixed(v) ? 0.0 : weight; });
  return load;
}

std::vector<double> SpectralDistance::PotentialOf(const SurfacePoint& point) const
{
  std::vector<double> values = this->LoadOf(point);
  this->Solver.GetSystem().Solve(values);
  return values;
}

/// Returns the Green's function of one point at another from the potentials of both. `load` is the
/// load of a.
double SpectralDistance::Product(
  const std::vector<double>& load, const std::vector<double>& a, const std::vector<double>& b) const
{
  const bool isBiharmonic = this->Options.Kind == SpectralKind::Biharmonic;
  const std::vector<double>& areas = this->Solver.GetAreas();
  double sum = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v)
  {
    sum += isBiharmonic ? areas[v] * a[v] * b[v] : load[v] * b[v];
  }
  return sum;
}

/// Returns the embedding of a point: spectral distances are Euclidean distances of embeddings.
std::vector<double> SpectralDistance::EmbeddingOf(const SurfacePoint& point) const
{
  const Eigenpairs& pairs = this->Pairs[this->Solver.GetSystem().GetComponent(point)];
  std::vector<double> embedding(pairs.Values.size(), 0.0);
  for (std::size_t k = 0; k < embedding.size(); ++k)
  {
    const double* function = pairs.Functions.data() + k * pairs.Vertices.size();
    ForEachCornerAround(this->Solver.GetMesh(), point,
      [&](Id v, double weight, double) { embedding[k] += weight * function[this->Places[v]]; });
    embedding[k] *= std::sqrt(this->Filter(pairs, k));
  }
  return embedding;
}

/// Computes the value of the Green's function at each vertex for a pole there: solves for all
/// vertices, eight at a time, at the cost of that many columns. Components are solved together.
Status SpectralDistance::FindDiagonal(const ParallelFor& parallel, const ProgressCallback& progress)
{
  const PoissonSystem& system = this->Solver.GetSystem();
  const auto n = static_cast<std::size_t>(system.GetNumberOfVertices());
  const bool isBiharmonic = this->Options.Kind == SpectralKind::Biharmonic;
  std::vector<double> diagonal(n, 0.0);
  // One vertex of each component at a time, since components are independent.
  std::vector<std::vector<Id>> rounds;
  std::vector<std::size_t> counts(static_cast<std::size_t>(system.GetNumberOfComponents()), 0);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    const std::size_t round = counts[system.GetComponent(v)]++;
    rounds.resize(std::max(rounds.size(), round + 1));
    rounds[round].push_back(v);
  }
  using Block = std::vector<SparseLanes>;
  const auto solveBlock = [&](Block& values, Offset, Offset begin, Offset end,
                            const ProgressCallback&) {
    values.assign(n, SparseLanes(SparseLanes::Zero()));
    for (Offset round = begin; round < end; ++round)
    {
      for (const Id v : rounds[round])
      {
        values[v][round - begin] = system.IsFixed(v) ? 0.0 : 1.0;
      }
    }
    system.Solve(values);
    Block sums(counts.size(), SparseLanes(SparseLanes::Zero()));
    for (std::size_t v = 0; v < n && isBiharmonic; ++v)
    {
      const Id id = static_cast<Id>(v);
      sums[system.GetComponent(id)] += values[v].square() * system.GetArea(id);
    }
    for (Offset round = begin; round < end; ++round)
    {
      for (const Id v : rounds[round])
      {
        const SparseLanes& from = isBiharmonic ? sums[system.GetComponent(v)] : values[v];
        diagonal[v] = from[round - begin];
      }
    }
    return Status::Success();
  };
  DGG_RETURN_IF_ERROR(ForBlocks(
    static_cast<Offset>(rounds.size()), BlockSize, parallel, progress, [] { return Block(); },
    solveBlock));
  this->Diagonal.swap(diagonal);
  return Status::Success();
}

/// Returns the Green's function of a point from its potential.
std::vector<double> SpectralDistance::ColumnOf(std::vector<double> potential) const
{
  const PoissonSystem& system = this->Solver.GetSystem();
  if (this->Options.Kind == SpectralKind::Biharmonic)
  {
    system.Integrate(potential);
    system.Solve(potential);
  }
  return potential;
}

Status SpectralDistance::FromPoint(const SurfacePoint& source, std::vector<double>& distances) const
{
  distances.clear();
  DGG_RETURN_IF_ERROR(this->CheckPrepared());
  DGG_RETURN_IF_ERROR(this->CheckPreparedSource(source));
  const PoissonSystem& system = this->Solver.GetSystem();
  const auto n = static_cast<std::size_t>(system.GetNumberOfVertices());
  const Id component = system.GetComponent(source);
  std::vector<double> squares(n, 0.0);
  if (this->Options.Method == SpectralMethod::Exact)
  {
    const std::vector<double> potential = this->PotentialOf(source);
    const std::vector<double> column = this->ColumnOf(potential);
    const double self = this->Product(this->LoadOf(source), potential, potential);
    for (std::size_t v = 0; v < n; ++v)
    {
      squares[v] = this->Diagonal[v] - 2.0 * column[v] + self;
    }
    if (IsVertex(source))
    {
      squares[source.Vertex] = 0.0; // not a rounding error
    }
  }
  else
  {
    const Eigenpairs& pairs = this->Pairs[component];
    const std::vector<double> embedding = this->EmbeddingOf(source);
    for (std::size_t k = 0; k < embedding.size(); ++k)
    {
      const double factor = std::sqrt(this->Filter(pairs, k));
      const double* function = pairs.Functions.data() + k * pairs.Vertices.size();
      for (std::size_t i = 0; i < pairs.Vertices.size(); ++i)
      {
        const double difference = factor * function[i] - embedding[k];
        squares[pairs.Vertices[i]] += difference * difference;
      }
    }
  }
  distances.resize(n);
  for (std::size_t v = 0; v < n; ++v)
  {
    distances[v] =
      system.GetComponent(static_cast<Id>(v)) == component ? Root(squares[v]) : Infinity;
  }
  return Status::Success();
}

Status SpectralDistance::Between(const std::vector<SurfacePoint>& first,
  const std::vector<SurfacePoint>& second, const ParallelFor& parallel,
  const ProgressCallback& progress, std::vector<double>& distances) const
{
  distances.clear();
  DGG_RETURN_IF_ERROR(this->CheckPrepared());
  for (const std::vector<SurfacePoint>* points : { &first, &second })
  {
    for (std::size_t k = 0; k < points->size(); ++k)
    {
      const SurfacePoint& point = (*points)[k];
      // In a thin component distances are unknown, but distances to other components are Infinity.
      DGG_RETURN_IF_ERROR(
        (points == &first ? this->CheckPreparedSource(point) : this->CheckPlace(point))
          .Of(JoinText("Point ", k)));
    }
  }
  // Vectors whose Euclidean distances are the spectral distances: potentials, weighted by areas, or
  // embeddings.
  const bool isExact = this->Options.Method == SpectralMethod::Exact;
  const auto findVectors = [&](const std::vector<SurfacePoint>& points, double begin, double end,
                             std::vector<std::vector<double>>& vectors) {
    vectors.resize(points.size());
    const double numbers =
      isExact ? this->GetNumbersOfSolve() : static_cast<double>(this->Options.NumberOfEigenvalues);
    return ForBlocks(static_cast<Offset>(points.size()), BlockOf(numbers), parallel,
      ProgressPart(progress, begin, end),
      [&](Offset, Offset first, Offset last, const ProgressCallback&) {
        for (Offset k = first; k < last; ++k)
        {
          vectors[k] = isExact ? this->PotentialOf(points[k]) : this->EmbeddingOf(points[k]);
        }
        return Status::Success();
      });
  };
  const bool isSame = &first == &second;
  std::vector<std::vector<double>> found[2];
  DGG_RETURN_IF_ERROR(findVectors(first, 0.0, isSame ? SolvesDone : 0.5 * SolvesDone, found[0]));
  DGG_RETURN_IF_ERROR(
    isSame ? Status::Success() : findVectors(second, 0.5 * SolvesDone, SolvesDone, found[1]));
  const std::vector<std::vector<double>>& rows = found[0];
  const std::vector<std::vector<double>>& columns = found[isSame ? 0 : 1];
  distances.assign(first.size() * second.size(), Infinity);
  const std::vector<double>& areas = this->Solver.GetAreas();
  const PoissonSystem& system = this->Solver.GetSystem();
  const bool isBiharmonic = this->Options.Kind == SpectralKind::Biharmonic;
  const auto distanceOf = [&](std::size_t i, std::size_t j) {
    if (system.GetComponent(first[i]) != system.GetComponent(second[j]))
    {
      return Infinity;
    }
    const std::vector<double>& a = rows[i];
    const std::vector<double>& b = columns[j];
    double square = 0.0;
    if (isExact && !isBiharmonic)
    {
      // Potential difference between the two points for a unit flow from one to the other.
      const SurfaceMesh& mesh = this->Solver.GetMesh();
      square = InterpolateAt(mesh, first[i], a) - InterpolateAt(mesh, second[j], a) -
        InterpolateAt(mesh, first[i], b) + InterpolateAt(mesh, second[j], b);
    }
    else
    {
      for (std::size_t v = 0; v < a.size(); ++v)
      {
        square += (isExact ? areas[v] : 1.0) * (a[v] - b[v]) * (a[v] - b[v]);
      }
    }
    return Root(square);
  };
  const auto pairs = static_cast<Offset>(distances.size());
  const double numbers = rows.empty() ? 1.0 : static_cast<double>(rows[0].size());
  Status status =
    ForBlocks(pairs, BlockOf(numbers), parallel, ProgressPart(progress, SolvesDone, 1.0),
      [&](Offset, Offset begin, Offset end, const ProgressCallback&) {
        for (Offset k = begin; k < end; ++k)
        {
          const auto pair = static_cast<std::size_t>(k);
          distances[pair] = distanceOf(pair / second.size(), pair % second.size());
        }
        return Status::Success();
      });
  if (!status.IsOk())
  {
    distances.clear();
  }
  return status;
}

/// Returns the number of values per solve: the entries of the factor, which is traversed twice.
double SpectralDistance::GetNumbersOfSolve() const
{
  return 2.0 * static_cast<double>(this->Solver.GetSystem().GetNumberOfFactorEntries());
}

std::size_t SpectralDistance::GetMemorySize() const
{
  return std::accumulate(this->Pairs.begin(), this->Pairs.end(),
    this->Diagonal.size() * sizeof(double) + this->Places.size() * sizeof(Id),
    [](std::size_t sum, const Eigenpairs& pairs) { return sum + pairs.GetMemorySize(); });
}
}
