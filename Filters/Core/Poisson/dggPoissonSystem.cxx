// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPoissonSystem.h"

#include "dggGeodesicSource.h"
#include "dggProgressPart.h"
#include "dggThinTriangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dgg
{
namespace
{
/// Bytes per face of the triangulation.
constexpr double BytesPerFace = 60.0;
/// Bytes per vertex of arrays, including the workspace of a solve.
constexpr double BytesPerVertex = 120.0;

/// Largest entry up to which solutions need no refinement.
constexpr double LargestHarmlessEntry = 1e3;
constexpr int MostRefinements = 20;
/// Tolerance of the residual, relative to the largest source and to the solution: both have the
/// same unit, and sources of 1 lead to values of about 1.
constexpr double GoodResidual = 1e-12;
/// Rounding error of a solution, relative to its largest value: the last four bits.
constexpr double LastBits = 16.0 * std::numeric_limits<double>::epsilon();
/// Up to this number of right-hand sides, separate solves take no longer than a joint solve of
/// eight.
constexpr std::size_t MostSingles = 4;

template <typename Number>
Number MakeZero();
template <>
double MakeZero<double>()
{
  return 0.0;
}
template <>
SparseLanes MakeZero<SparseLanes>()
{
  return SparseLanes::Zero();
}

double Largest(const std::vector<double>& values)
{
  double largest = 0.0;
  for (const double value : values)
  {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}
}

PoissonSystem::PoissonSystem(const SurfaceMesh& mesh)
  : LaplaceSystem(mesh)
  , TriangleOfFace(mesh.GetNumberOfFaces(), NoId)
{
  Id count = 0;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    this->TriangleOfFace[f] = mesh.IsDropped(f) ? NoId : count++;
  }
}

Status PoissonSystem::Analyze(const PoissonOptions& options, const ProgressCallback& progress)
{
  const bool isSameMatrix = this->IsAnalyzed &&
    this->Options.IntrinsicDelaunay == options.IntrinsicDelaunay &&
    this->Options.Boundary == options.Boundary &&
    this->Options.DirichletVertices == options.DirichletVertices;
  if (isSameMatrix)
  {
    this->Revision += this->Options.Weights == options.Weights ? 0 : 1;
    this->Options = options;
    this->SetWeights();
    return Status::Success();
  }
  DGG_RETURN_IF_ERROR(this->CheckDirichletVertices(options.DirichletVertices));
  this->Factor.Clear();
  this->IsAnalyzed = false;
  ++this->Revision;
  this->Options = options;
  DGG_RETURN_IF_ERROR(this->Build(options.IntrinsicDelaunay, LargestCotangent, progress));
  const Eigen::VectorXd diagonal = this->Stiffness.diagonal().cwiseAbs();
  this->Diagonal.assign(diagonal.data(), diagonal.data() + diagonal.size());
  this->LargestEntry = diagonal.size() > 0 ? diagonal.maxCoeff() : 0.0;
  this->MeasureComponents();
  this->MarkDirichletVertices();
  this->SetWeights();
  for (Id c = 0; c < this->GetNumberOfComponents(); ++c)
  {
    this->Pinned[c] = this->IsFree(c) ? this->Pinned[c] : NoId;
  }
  this->IsAnalyzed = true;
  return ReportTo(progress, 1.0);
}

void PoissonSystem::MeasureComponents()
{
  const Id count = this->NumberOfComponents;
  this->ComponentAreas.assign(count, 0.0);
  this->ComponentIsThin.assign(count, 0);
  this->MeanEdges.assign(count, 0.0);
  this->MeanLongestSides.assign(count, 0.0);
  this->ComponentHasBoundary.assign(count, 0);
  std::vector<Offset> sides(count, 0);
  for (Id h = 0; h < this->Triangulation.GetNumberOfHalfEdges(); ++h)
  {
    const Id c = this->Components[this->Triangulation.Origin(h)];
    this->MeanEdges[c] += this->Triangulation.Length(h);
    ++sides[c];
    if (this->Triangulation.Twin(h) == NoId)
    {
      this->ComponentHasBoundary[c] = 1;
    }
  }
  for (std::size_t v = 0; v < this->Areas.size(); ++v)
  {
    this->ComponentAreas[this->Components[v]] += this->Areas[v];
  }
  for (Id f = 0; f < this->Triangulation.GetNumberOfFaces(); ++f)
  {
    const double longest = std::max({ this->Triangulation.Length(3 * f),
      this->Triangulation.Length(3 * f + 1), this->Triangulation.Length(3 * f + 2) });
    const Id c = this->Components[this->Triangulation.Origin(3 * f)];
    this->MeanLongestSides[c] += this->Triangulation.Area(f) / this->ComponentAreas[c] * longest;
  }
  for (Id c = 0; c < count; ++c)
  {
    this->MeanEdges[c] /= std::max(1.0, static_cast<double>(sides[c]));
  }
}

Status PoissonSystem::CheckDirichletVertices(const std::vector<Id>& vertices) const
{
  const Id n = this->Mesh.GetNumberOfVertices();
  for (const Id v : vertices)
  {
    if (v < 0 || v >= n)
    {
      return InvalidInput("A value is given at vertex ", v, ", which does not exist")
        .Fix("Use ids from 0 to ", n - 1);
    }
  }
  return Status::Success();
}

void PoissonSystem::MarkDirichletVertices()
{
  const bool isDirichlet = this->Options.Boundary == PoissonBoundary::Dirichlet;
  this->Fixed.assign(this->Components.size(), 0);
  if (isDirichlet)
  {
    this->Fixed = this->OnBoundary;
  }
  for (const Id v : this->Options.DirichletVertices)
  {
    this->Fixed[v] = 1;
  }
  this->ComponentHasDirichlet.assign(this->ComponentAreas.size(), 0);
  for (std::size_t v = 0; v < this->Fixed.size(); ++v)
  {
    std::uint8_t& hasGiven = this->ComponentHasDirichlet[this->Components[v]];
    hasGiven = hasGiven | this->Fixed[v];
  }
}

bool PoissonSystem::IsFixed(const SurfacePoint& point) const
{
  bool isFixed = true;
  ForEachCornerAround(this->Mesh, point, [&](Id v, double weight, double) {
    isFixed = isFixed && (!(weight > 0.0) || this->IsFixed(v));
  });
  return isFixed;
}

void PoissonSystem::SetWeights()
{
  const std::size_t n = this->Areas.size();
  const bool isByArea = this->Options.Weights == PoissonWeights::Area;
  std::vector<double> totals(this->ComponentAreas.size(), 0.0);
  this->Weights.resize(n);
  for (std::size_t v = 0; v < n; ++v)
  {
    const Id c = this->Components[v];
    // Vertices without a face are components without area.
    const bool hasArea = this->ComponentAreas[c] > 0.0;
    this->Weights[v] = isByArea && hasArea ? this->Areas[v] : 1.0;
    totals[c] += this->Weights[v];
  }
  for (std::size_t v = 0; v < n; ++v)
  {
    this->Weights[v] /= totals[this->Components[v]];
  }
}

std::array<double, 3> PoissonSystem::GetCotangents(Id face) const
{
  return dgg::GetCotangents(this->Triangulation, face, LargestCotangent);
}

Status PoissonSystem::Factorize(const ProgressCallback& progress)
{
  if (!this->IsAnalyzed)
  {
    return InvalidInput("The system has not been analyzed").Fix("Call Analyze() first");
  }
  if (this->Factor.IsComputed())
  {
    return Status::Success();
  }
  std::vector<std::uint8_t> isKnown(this->Components.size(), 0);
  for (Id v = 0; v < this->GetNumberOfVertices(); ++v)
  {
    isKnown[v] = this->IsFixed(v) || this->IsPinned(v);
  }
  ++this->NumberOfFactorizations;
  DGG_RETURN_IF_ERROR(this->Factor.Compute(this->Order, this->Stiffness, isKnown, progress));
  Status status =
    this->NeedsRefinement() ? CheckThinTriangles(*this, this->ComponentIsThin) : Status::Success();
  if (!status.IsOk())
  {
    this->Factor.Clear();
  }
  return status;
}

bool PoissonSystem::HasThin() const
{
  return std::find(this->ComponentIsThin.begin(), this->ComponentIsThin.end(), 1) !=
    this->ComponentIsThin.end();
}

double PoissonSystem::GetEstimatedMemory() const
{
  const auto n = static_cast<double>(this->Components.size());
  constexpr double entry = sizeof(double) + sizeof(int);
  return static_cast<double>(this->Triangulation.GetNumberOfFaces()) * BytesPerFace +
    static_cast<double>(this->Stiffness.nonZeros()) * entry + n * BytesPerVertex +
    this->Order.EstimateFactorMemory();
}

// Solves with a factorized system: balance the sources, substitute, refine, center the solution.
std::vector<double> PoissonSystem::Multiply(const std::vector<double>& f) const
{
  std::vector<double> result(f.size(), 0.0);
  for (int column = 0; column < this->Stiffness.cols(); ++column)
  {
    // Differences, so that constants give exactly 0.
    double sum = 0.0;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(this->Stiffness, column); entry; ++entry)
    {
      sum += entry.value() * (f[entry.row()] - f[column]);
    }
    result[column] = sum;
  }
  return result;
}

template <typename Number>
void PoissonSystem::Balance(std::vector<Number>& values) const
{
  std::vector<Number> sums(this->ComponentAreas.size(), MakeZero<Number>());
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    sums[this->Components[v]] += values[v];
  }
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    const Id c = this->Components[v];
    if (this->IsFree(c))
    {
      values[v] -= sums[c] * this->Weights[v];
    }
  }
}

template <typename Number>
void PoissonSystem::Center(std::vector<Number>& values) const
{
  std::vector<Number> means(this->ComponentAreas.size(), MakeZero<Number>());
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    means[this->Components[v]] += values[v] * this->Weights[v];
  }
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    const Id c = this->Components[v];
    if (this->IsFree(c))
    {
      values[v] -= means[c];
    }
  }
}

template void PoissonSystem::Center(std::vector<double>& values) const;

/// Subtracts the contribution of vertices with given values.
template <typename Number>
void PoissonSystem::TakeDirichletValuesOff(std::vector<Number>& values) const
{
  for (int column = 0; column < this->Stiffness.cols(); ++column)
  {
    if (!this->IsFixed(column))
    {
      continue;
    }
    const Number value = values[column];
    for (Eigen::SparseMatrix<double>::InnerIterator entry(this->Stiffness, column); entry; ++entry)
    {
      if (!this->IsFixed(static_cast<Id>(entry.row())))
      {
        values[entry.row()] -= value * entry.value();
      }
    }
  }
}

template <typename Number>
void PoissonSystem::SolveOnce(std::vector<Number>& values) const
{
  this->Balance(values);
  this->TakeDirichletValuesOff(values);
  for (const Id v : this->Pinned)
  {
    if (v != NoId)
    {
      values[v] = MakeZero<Number>();
    }
  }
  this->Factor.Solve(values);
  this->Center(values);
}

/// Refines a solution by conjugate gradients with the factor as preconditioner. One step suffices
/// for a good factor, a few if the diagonal had to be increased. Residuals within the rounding
/// error of the solution do not trigger a step.
void PoissonSystem::Refine(const std::vector<double>& sources, std::vector<double>& solution) const
{
  const std::size_t n = sources.size();
  const auto findResidual = [&](std::vector<double>& residual) {
    residual = this->Multiply(solution);
    for (std::size_t v = 0; v < n; ++v)
    {
      residual[v] = this->IsFixed(static_cast<Id>(v)) ? 0.0 : sources[v] - residual[v];
    }
  };
  std::vector<double> residual;
  findResidual(residual);
  const double largest = Largest(solution);
  const double negligible = GoodResidual * std::max(Largest(sources), largest);
  const double rounding = LastBits * largest;
  const auto sizeOf = [&](const std::vector<double>& values) {
    double size = 0.0;
    for (std::size_t v = 0; v < n; ++v)
    {
      const double allowed = negligible + rounding * this->Diagonal[v];
      size = std::max(size, allowed > 0.0 ? std::abs(values[v]) / allowed : 0.0);
    }
    return size;
  };
  double best = sizeOf(residual);
  std::vector<double> direction;
  double previous = 0.0;
  for (int step = 0; step < MostRefinements && best > 1.0; ++step)
  {
    std::vector<double> steepest = residual;
    this->SolveOnce(steepest);
    double product = 0.0;
    for (std::size_t v = 0; v < n; ++v)
    {
      product += steepest[v] * residual[v];
    }
    if (direction.empty())
    {
      direction = steepest;
    }
    else
    {
      for (std::size_t v = 0; v < n; ++v)
      {
        direction[v] = steepest[v] + product / previous * direction[v];
      }
    }
    const std::vector<double> change = this->Multiply(direction);
    double curvature = 0.0;
    for (std::size_t v = 0; v < n; ++v)
    {
      curvature += this->IsFixed(static_cast<Id>(v)) ? 0.0 : change[v] * direction[v];
    }
    if (!(curvature > 0.0) || !(product > 0.0))
    {
      break;
    }
    std::vector<double> before = solution;
    for (std::size_t v = 0; v < n; ++v)
    {
      solution[v] += product / curvature * direction[v];
    }
    findResidual(residual);
    const double size = sizeOf(residual);
    if (!(size < best))
    {
      solution.swap(before);
      break;
    }
    best = size;
    previous = product;
  }
  this->Center(solution);
}

bool PoissonSystem::NeedsRefinement() const
{
  return this->LargestEntry > LargestHarmlessEntry || this->Factor.IsRaised();
}

void PoissonSystem::Solve(std::vector<double>& values) const
{
  if (!this->NeedsRefinement())
  {
    this->SolveOnce(values);
    return;
  }
  std::vector<double> sources = values;
  this->Balance(sources);
  this->SolveOnce(values);
  this->Refine(sources, values);
}

void PoissonSystem::Solve(std::vector<SparseLanes>& block) const
{
  const std::vector<SparseLanes> given =
    this->NeedsRefinement() ? block : std::vector<SparseLanes>();
  this->SolveOnce(block);
  std::vector<double> sources(given.size());
  std::vector<double> solution(given.size());
  for (int k = 0; k < SparseLanes::SizeAtCompileTime && !given.empty(); ++k)
  {
    for (std::size_t v = 0; v < given.size(); ++v)
    {
      sources[v] = given[v][k];
      solution[v] = block[v][k];
    }
    this->Balance(sources);
    this->Refine(sources, solution);
    for (std::size_t v = 0; v < given.size(); ++v)
    {
      block[v][k] = solution[v];
    }
  }
}

void PoissonSystem::Solve(std::vector<std::vector<double>>& columns) const
{
  constexpr std::size_t lanes = SparseLanes::SizeAtCompileTime;
  for (std::size_t begin = 0; begin < columns.size(); begin += lanes)
  {
    const std::size_t count = std::min(lanes, columns.size() - begin);
    if (count <= MostSingles)
    {
      for (std::size_t k = begin; k < begin + count; ++k)
      {
        this->Solve(columns[k]);
      }
      continue;
    }
    std::vector<SparseLanes> block(columns[begin].size(), SparseLanes::Zero());
    for (std::size_t v = 0; v < block.size(); ++v)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        block[v][static_cast<int>(k)] = columns[begin + k][v];
      }
    }
    this->Solve(block);
    for (std::size_t v = 0; v < block.size(); ++v)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        columns[begin + k][v] = block[v][static_cast<int>(k)];
      }
    }
  }
}

void PoissonSystem::Integrate(std::vector<double>& density) const
{
  for (std::size_t v = 0; v < density.size(); ++v)
  {
    density[v] *= this->IsFixed(static_cast<Id>(v)) ? 0.0 : this->Areas[v];
  }
}

void PoissonSystem::SolveBiLaplace(std::vector<std::vector<double>>& columns) const
{
  for (std::vector<double>& column : columns)
  {
    for (std::size_t v = 0; v < column.size(); ++v)
    {
      column[v] = this->IsFixed(static_cast<Id>(v)) ? 0.0 : column[v];
    }
  }
  this->Solve(columns);
  for (std::vector<double>& column : columns)
  {
    this->Integrate(column);
  }
  this->Solve(columns);
}
}
