// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSpectralDistance.h"

#include "dggGreensColumn.h"
#include "dggGeodesicSource.h"
#include "dggPoissonSystem.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>
#include <utility>

namespace dgg
{
namespace
{
constexpr Offset Lanes = SparseLanes::SizeAtCompileTime;

/// Differences of squares, never below 0 by rounding.
double Root(double square)
{
  return std::sqrt(std::max(0.0, square));
}
}

SpectralDistance::SpectralDistance(const PoissonSolver& solver)
  : Solver(solver)
{
}

Status SpectralDistance::Prepare(const SpectralOptions& options, Eigenpairs pairs)
{
  this->IsPrepared = false;
  this->Diagonal.clear();
  if (!this->Solver.IsReady())
  {
    return Status::Invalid("the solver has not been prepared: call Prepare() first");
  }
  if (!(options.Time >= 0.0) || !(options.Time < Infinity))
  {
    return Status::Invalid("the time of diffusion must not be negative, and finite");
  }
  if (options.Kind == SpectralKind::Diffusion && options.Method == SpectralMethod::Exact)
  {
    return Status::Invalid("diffusion distances need eigenvalues: use the method Spectrum");
  }
  const auto n = static_cast<std::size_t>(this->Solver.GetMesh().GetNumberOfVertices());
  if (options.Method == SpectralMethod::Spectrum &&
    pairs.Functions.size() != pairs.Values.size() * n)
  {
    return Status::Invalid("the eigenfunctions do not have one value for each vertex");
  }
  this->Options = options;
  this->Pairs = std::move(pairs);
  this->Time = options.Time > 0.0 || this->Pairs.Values.empty() ? options.Time
                                                                : 0.1 / this->Pairs.Values.front();
  this->IsPrepared = true;
  return Status::Success();
}

Status SpectralDistance::Prepare(const SpectralOptions& options, const ProgressCallback& progress)
{
  Eigenpairs pairs;
  if (options.Method == SpectralMethod::Spectrum)
  {
    Status status = FindEigenpairs(this->Solver, options.NumberOfEigenvalues, progress, pairs);
    if (!status.IsOk())
    {
      return status;
    }
  }
  return this->Prepare(options, std::move(pairs));
}

double SpectralDistance::Filter(double eigenvalue) const
{
  switch (this->Options.Kind)
  {
    case SpectralKind::Biharmonic:
      return 1.0 / (eigenvalue * eigenvalue);
    case SpectralKind::CommuteTime:
      return 1.0 / eigenvalue;
    case SpectralKind::Diffusion:
      break;
  }
  return std::exp(-2.0 * this->Time * eigenvalue);
}

Id SpectralDistance::ComponentOf(const SurfacePoint& point) const
{
  const Id v = IsVertex(point) ? point.Vertex : this->Solver.GetMesh().Origin(3 * point.Face);
  return this->Solver.GetSystem().GetComponent(v);
}

Status SpectralDistance::CheckPoint(const SurfacePoint& point) const
{
  if (!this->IsPrepared)
  {
    return Status::Invalid("the distance has not been prepared: call Prepare() first");
  }
  return point.Check(this->Solver.GetMesh());
}

/// Unit load, 0 where values are given.
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

/// Of potentials of points: the Green's function at the one, of the other. `load` is that of a.
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

/// The vector whose distances are the distances.
std::vector<double> SpectralDistance::EmbeddingOf(const SurfacePoint& point) const
{
  const auto n = static_cast<std::size_t>(this->Solver.GetMesh().GetNumberOfVertices());
  std::vector<double> embedding(this->Pairs.Values.size(), 0.0);
  for (std::size_t k = 0; k < embedding.size(); ++k)
  {
    const double* function = this->Pairs.Functions.data() + k * n;
    ForEachCornerAround(this->Solver.GetMesh(), point,
      [&](Id v, double weight, double) { embedding[k] += weight * function[v]; });
    embedding[k] *= std::sqrt(this->Filter(this->Pairs.Values[k]));
  }
  return embedding;
}

Status SpectralDistance::FindDiagonal(const ParallelFor& parallel, const ProgressCallback& progress)
{
  const PoissonSystem& system = this->Solver.GetSystem();
  const Offset n = system.GetNumberOfVertices();
  std::vector<double> diagonal(n, 0.0);
  Status status;
  std::mutex mutex;
  Offset done = 0;
  ForRange(parallel, (n + Lanes - 1) / Lanes, 1, [&](Offset begin, Offset end) {
    std::vector<SparseLanes> values(n);
    for (Offset block = begin; block < end; ++block)
    {
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (status.IsOk() && progress &&
          !progress(static_cast<double>(done) / static_cast<double>(n)))
        {
          status = Status::Abort();
        }
        if (!status.IsOk())
        {
          return;
        }
      }
      const Offset first = block * Lanes;
      const Offset size = std::min(Lanes, n - first);
      std::fill(values.begin(), values.end(), SparseLanes(SparseLanes::Zero()));
      for (Offset k = 0; k < size; ++k)
      {
        values[first + k][k] = system.IsFixed(static_cast<Id>(first + k)) ? 0.0 : 1.0;
      }
      system.Solve(values);
      if (this->Options.Kind == SpectralKind::Biharmonic)
      {
        SparseLanes sum = SparseLanes::Zero();
        for (Offset v = 0; v < n; ++v)
        {
          sum += values[v].square() * system.GetArea(static_cast<Id>(v));
        }
        for (Offset k = 0; k < size; ++k)
        {
          diagonal[first + k] = sum[k];
        }
      }
      else
      {
        for (Offset k = 0; k < size; ++k)
        {
          diagonal[first + k] = values[first + k][k];
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      done += size;
    }
  });
  if (status.IsOk())
  {
    this->Diagonal.swap(diagonal);
  }
  return status;
}

Status SpectralDistance::Column(const SurfacePoint& source, std::vector<double>& values) const
{
  values.clear();
  Status status = this->CheckPoint(source);
  if (!status.IsOk())
  {
    return status;
  }
  const PoissonSystem& system = this->Solver.GetSystem();
  if (this->Options.Method == SpectralMethod::Exact)
  {
    values = this->PotentialOf(source);
    if (this->Options.Kind == SpectralKind::Biharmonic)
    {
      for (std::size_t v = 0; v < values.size(); ++v)
      {
        values[v] *= system.IsFixed(static_cast<Id>(v)) ? 0.0 : this->Solver.GetAreas()[v];
      }
      system.Solve(values);
    }
    return status;
  }
  const std::vector<double> embedding = this->EmbeddingOf(source);
  const auto n = static_cast<std::size_t>(system.GetNumberOfVertices());
  values.assign(n, 0.0);
  for (std::size_t k = 0; k < embedding.size(); ++k)
  {
    const double factor = embedding[k] * std::sqrt(this->Filter(this->Pairs.Values[k]));
    const double* function = this->Pairs.Functions.data() + k * n;
    for (std::size_t v = 0; v < n; ++v)
    {
      values[v] += factor * function[v];
    }
  }
  return status;
}

Status SpectralDistance::FromPoint(const SurfacePoint& source, const ParallelFor& parallel,
  const ProgressCallback& progress, std::vector<double>& distances)
{
  distances.clear();
  Status status = this->CheckPoint(source);
  if (!status.IsOk())
  {
    return status;
  }
  const PoissonSystem& system = this->Solver.GetSystem();
  const auto n = static_cast<std::size_t>(system.GetNumberOfVertices());
  std::vector<double> squares(n, 0.0);
  if (this->Options.Method == SpectralMethod::Exact)
  {
    if (this->Diagonal.empty())
    {
      status = this->FindDiagonal(parallel, progress);
    }
    std::vector<double> column;
    status = status.IsOk() ? this->Column(source, column) : status;
    if (!status.IsOk())
    {
      return status;
    }
    const std::vector<double> potential = this->PotentialOf(source);
    const double self = this->Product(this->LoadOf(source), potential, potential);
    for (std::size_t v = 0; v < n; ++v)
    {
      squares[v] = this->Diagonal[v] - 2.0 * column[v] + self;
    }
    if (IsVertex(source))
    {
      squares[source.Vertex] = 0.0; // not what rounding leaves
    }
  }
  else
  {
    const std::vector<double> embedding = this->EmbeddingOf(source);
    for (std::size_t k = 0; k < embedding.size(); ++k)
    {
      const double factor = std::sqrt(this->Filter(this->Pairs.Values[k]));
      const double* function = this->Pairs.Functions.data() + k * n;
      for (std::size_t v = 0; v < n; ++v)
      {
        const double difference = factor * function[v] - embedding[k];
        squares[v] += difference * difference;
      }
    }
  }
  distances.resize(n);
  const Id component = this->ComponentOf(source);
  for (std::size_t v = 0; v < n; ++v)
  {
    distances[v] =
      system.GetComponent(static_cast<Id>(v)) == component ? Root(squares[v]) : Infinity;
  }
  return status;
}

Status SpectralDistance::Between(const std::vector<SurfacePoint>& first,
  const std::vector<SurfacePoint>& second, const ParallelFor& parallel,
  const ProgressCallback& progress, std::vector<double>& distances) const
{
  distances.clear();
  for (const std::vector<SurfacePoint>* points : { &first, &second })
  {
    for (std::size_t k = 0; k < points->size(); ++k)
    {
      const Status status = this->CheckPoint((*points)[k]);
      if (!status.IsOk())
      {
        return Status::Invalid("point " + std::to_string(k) + ": " + status.GetMessage());
      }
    }
  }
  // Vectors whose distances are the distances: potentials, with areas as weights, or embeddings.
  const bool isExact = this->Options.Method == SpectralMethod::Exact;
  const auto vectorsOf = [&](const std::vector<SurfacePoint>& points) {
    std::vector<std::vector<double>> vectors(points.size());
    ForRange(parallel, static_cast<Offset>(points.size()), 1, [&](Offset begin, Offset end) {
      for (Offset k = begin; k < end; ++k)
      {
        vectors[k] = isExact ? this->PotentialOf(points[k]) : this->EmbeddingOf(points[k]);
      }
    });
    return vectors;
  };
  const std::vector<std::vector<double>> rows = vectorsOf(first);
  if (progress && !progress(0.4))
  {
    return Status::Abort();
  }
  const std::vector<std::vector<double>> columns = vectorsOf(second);
  if (progress && !progress(0.8))
  {
    return Status::Abort();
  }
  distances.assign(first.size() * second.size(), Infinity);
  const std::vector<double>& areas = this->Solver.GetAreas();
  const bool isBiharmonic = this->Options.Kind == SpectralKind::Biharmonic;
  ForRange(parallel, static_cast<Offset>(first.size()), 1, [&](Offset begin, Offset end) {
    for (Offset i = begin; i < end; ++i)
    {
      for (std::size_t j = 0; j < second.size(); ++j)
      {
        if (this->ComponentOf(first[i]) != this->ComponentOf(second[j]))
        {
          continue;
        }
        const std::vector<double>& a = rows[i];
        const std::vector<double>& b = columns[j];
        double square = 0.0;
        if (isExact && !isBiharmonic)
        {
          // Potential difference of the two points while a unit flows from one to the other.
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
        distances[i * second.size() + j] = Root(square);
      }
    }
  });
  return progress && !progress(1.0) ? Status::Abort() : Status::Success();
}

std::size_t SpectralDistance::GetMemorySize() const
{
  return this->Pairs.GetMemorySize() + this->Diagonal.size() * sizeof(double);
}
}
