// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPoissonSystem.h"

#include "dggCotanLaplacian.h"
#include "dggIntrinsicDelaunay.h"
#include "dggThinTriangles.h"

#include <algorithm>
#include <limits>
#include <string>

namespace dgg
{
namespace
{
/// Of the triangulation.
constexpr double BytesPerFace = 60.0;
/// Of arrays, and of what a solution works with.
constexpr double BytesPerVertex = 120.0;

bool Goes(const ProgressCallback& progress, double fraction)
{
  return !progress || progress(fraction);
}
}

PoissonSystem::PoissonSystem(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , Triangulation(mesh)
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
    this->Options.GivenVertices == options.GivenVertices;
  if (isSameMatrix)
  {
    this->Revision += this->Options.Weights == options.Weights ? 0 : 1;
    this->Options = options;
    this->SetWeights();
    return Status::Success();
  }
  Status given = this->CheckGivenVertices(options.GivenVertices);
  if (!given.IsOk())
  {
    return given;
  }
  this->Factor.Clear();
  this->IsAnalyzed = false;
  ++this->Revision;
  this->Options = options;
  if (!Goes(progress, 0.0))
  {
    return Status::Abort();
  }
  this->Triangulation = IntrinsicTriangulation(this->Mesh);
  if (options.IntrinsicDelaunay)
  {
    DelaunayReport report;
    Status status = MakeDelaunay(
      this->Triangulation, -1, [&](double f) { return Goes(progress, 0.4 * f); }, report);
    if (!status.IsOk())
    {
      return status;
    }
  }
  if (!Goes(progress, 0.4))
  {
    return Status::Abort();
  }
  CotanLaplacian laplacian = MakeCotanLaplacian(this->Triangulation, LargestCotangent);
  this->Stiffness.swap(laplacian.Stiffness);
  this->Areas.assign(laplacian.Mass.data(), laplacian.Mass.data() + laplacian.Mass.size());
  const Eigen::VectorXd diagonal = this->Stiffness.diagonal().cwiseAbs();
  this->Diagonal.assign(diagonal.data(), diagonal.data() + diagonal.size());
  this->LargestEntry = diagonal.size() > 0 ? diagonal.maxCoeff() : 0.0;
  this->MeasureComponents();
  this->MarkGivenVertices();
  this->SetWeights();
  if (!Goes(progress, 0.5))
  {
    return Status::Abort();
  }
  this->Places = FindEliminationOrder(this->Stiffness);
  this->PinnedPlaces.assign(this->ComponentAreas.size(), NoId);
  for (std::size_t v = 0; v < this->Places.size(); ++v)
  {
    const Id c = this->Components[v];
    if (this->IsFree(c))
    {
      this->PinnedPlaces[c] = std::max(this->PinnedPlaces[c], this->Places[v]);
    }
  }
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation(this->Stiffness.cols());
  std::copy(this->Places.begin(), this->Places.end(), permutation.indices().data());
  Eigen::SparseMatrix<double> upper(this->Stiffness.rows(), this->Stiffness.cols());
  upper.selfadjointView<Eigen::Upper>() =
    this->Stiffness.selfadjointView<Eigen::Upper>().twistedBy(permutation);
  this->FactorEntries = CountFactorEntries(upper);
  this->IsAnalyzed = true;
  return Goes(progress, 1.0) ? Status::Success() : Status::Abort();
}

void PoissonSystem::MeasureComponents()
{
  Id count = 0;
  this->Components = this->Mesh.ComputeComponents(count);
  this->OnBoundary.assign(this->Components.size(), 0);
  this->ComponentAreas.assign(count, 0.0);
  this->ComponentIsThin.assign(count, 0);
  this->MeanEdges.assign(count, 0.0);
  this->MeanLongestSides.assign(count, 0.0);
  this->ComponentHasBoundary.assign(count, 0);
  this->LongestEdge = 0.0;
  std::vector<Offset> sides(count, 0);
  for (Id h = 0; h < this->Triangulation.GetNumberOfHalfEdges(); ++h)
  {
    const Id v = this->Triangulation.Origin(h);
    const Id c = this->Components[v];
    this->MeanEdges[c] += this->Triangulation.Length(h);
    ++sides[c];
    this->LongestEdge = std::max(this->LongestEdge, this->Triangulation.Length(h));
    if (this->Triangulation.Twin(h) == NoId)
    {
      this->OnBoundary[v] = 1;
      this->OnBoundary[this->Triangulation.Destination(h)] = 1;
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

Status PoissonSystem::CheckGivenVertices(const std::vector<Id>& vertices) const
{
  const Id n = this->Mesh.GetNumberOfVertices();
  for (const Id v : vertices)
  {
    if (v < 0 || v >= n)
    {
      return Status::Invalid("a value is given at vertex " + std::to_string(v) +
        ", which does not exist: ids must be in [0, " + std::to_string(n - 1) + "]");
    }
  }
  return Status::Success();
}

void PoissonSystem::MarkGivenVertices()
{
  const bool isDirichlet = this->Options.Boundary == PoissonBoundary::Dirichlet;
  this->Fixed.assign(this->Components.size(), 0);
  if (isDirichlet)
  {
    this->Fixed = this->OnBoundary;
  }
  for (const Id v : this->Options.GivenVertices)
  {
    this->Fixed[v] = 1;
  }
  this->ComponentHasGiven.assign(this->ComponentAreas.size(), 0);
  for (std::size_t v = 0; v < this->Fixed.size(); ++v)
  {
    std::uint8_t& hasGiven = this->ComponentHasGiven[this->Components[v]];
    hasGiven = hasGiven | this->Fixed[v];
  }
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
    // Vertices without a face are components that have no area.
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

Status PoissonSystem::Factorize()
{
  if (!this->IsAnalyzed)
  {
    return Status::Invalid("the system has not been analyzed: call Analyze() first");
  }
  if (this->Factor.IsComputed())
  {
    return Status::Success();
  }
  if (this->FactorEntries > std::numeric_limits<int>::max())
  {
    return Status::Invalid("the factor of the linear system would have " +
      std::to_string(this->FactorEntries) +
      " entries, more than can be numbered: use a smaller mesh");
  }
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation(this->Stiffness.cols());
  std::copy(this->Places.begin(), this->Places.end(), permutation.indices().data());
  Eigen::SparseMatrix<double> upper(this->Stiffness.rows(), this->Stiffness.cols());
  upper.selfadjointView<Eigen::Upper>() =
    this->Stiffness.selfadjointView<Eigen::Upper>().twistedBy(permutation);
  std::vector<std::uint8_t> isKnown(this->Places.size(), 0);
  for (std::size_t v = 0; v < this->Places.size(); ++v)
  {
    const Id place = this->Places[v];
    isKnown[place] = this->IsFixed(static_cast<Id>(v)) || this->IsPinned(static_cast<Id>(v));
  }
  for (int column = 0; column < upper.cols(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(upper, column); entry; ++entry)
    {
      if (isKnown[column] || isKnown[entry.row()])
      {
        entry.valueRef() = entry.row() == column ? 1.0 : 0.0;
      }
    }
  }
  ++this->NumberOfFactorizations;
  if (!this->Factor.Compute(upper))
  {
    return Status::Invalid(
      "the linear system could not be factorized: remove triangles that have next to no area");
  }
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
    SparseFactor::EstimateMemory(this->Stiffness, this->FactorEntries);
}
}
