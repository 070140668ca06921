// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSplineCells.h"

#include "dggBlockLoop.h"
#include "dggExactGeodesics.h"
#include "dggGroups.h"
#include "dggProgressPart.h"

#include <Eigen/SparseCholesky> // for the factorization

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace dgg
{
namespace
{
/// Progress after the partition and after the fluxes to given values.
constexpr double PartitionDone = 0.25;
constexpr double RimsDone = 0.35;
/// Maximum residual of the equations of sites, relative to the right-hand side, and tolerance of
/// rounding errors.
constexpr double Tolerance = 1e-8;

using Entries = Eigen::SparseMatrix<double>::InnerIterator;
using Triplets = std::vector<Eigen::Triplet<double, int>>;

bool IsInACell(const PoissonSystem& system, Id v)
{
  const SurfaceMesh& mesh = system.GetMesh();
  return mesh.FanBegin(v) != mesh.FanEnd(v) && !system.IsFixed(v);
}

/// Contributions found from one site: other sites, possibly repeated, and shares of coefficients.
using SiteRow = std::vector<std::pair<Id, double>>;

/// Computes the contribution of one cell to the coefficients, from the distances of its own site.
class CellFluxes
{
public:
  CellFluxes(
    const PoissonSystem& system, const std::vector<Id>& sites, const std::vector<Id>& cells)
    : System(system)
    , Sites(sites)
    , Cells(cells)
    , Vertices(MakeGroups(cells, sites.size()))
    , Radii(sites.size(), 0.0)
  {
  }

  /// Computes the radius of distances needed from each site: up to the vertices adjacent to its
  /// cell and the sites of these vertices. `distances` are from the nearest sites.
  void FindRadii(const std::vector<double>& distances)
  {
    const IntrinsicTriangulation& triangulation = this->System.GetTriangulation();
    for (Id h = 0; h < triangulation.GetNumberOfHalfEdges(); ++h)
    {
      const Id ends[] = { triangulation.Origin(h), triangulation.Destination(h) };
      for (int k = 0; k < 2; ++k)
      {
        const Id cell = this->Cells[ends[k]];
        const Id other = this->Cells[ends[1 - k]];
        if (cell != NoId && cell != other)
        {
          const double beyond = other == NoId ? 0.0 : distances[ends[1 - k]];
          this->Radii[cell] =
            std::max(this->Radii[cell], distances[ends[k]] + triangulation.Length(h) + beyond);
        }
      }
    }
  }

  Status Run(
    std::size_t site, const ProgressCallback& progress, ExactGeodesics& exact, SiteRow& row) const
  {
    // Margin, so that rounding does not exclude the farthest one.
    const double radius = this->Radii[site] * (1.0 + 1e-9);
    ExactOptions options;
    options.MaximumDistance = radius;
    options.Progress = progress;
    ExactResult result;
    DGG_RETURN_IF_ERROR(
      exact.Run({ { SurfacePoint::AtVertex(this->Sites[site]), 0.0 } }, options, result));
    const auto distance = [&](Id v) { return std::min(result.Distances[v], radius); };
    for (Offset k = this->Vertices.Begins[site]; k < this->Vertices.Begins[site + 1]; ++k)
    {
      const Id u = this->Vertices.Members[k];
      const double near = distance(u);
      for (Entries entry(this->System.GetStiffness(), u); entry; ++entry)
      {
        const Id v = static_cast<Id>(entry.row());
        const Id other = this->Cells[v];
        const double weight = -entry.value();
        if (other != static_cast<Id>(site) && other != NoId)
        {
          const double far = distance(v);
          const double between = distance(this->Sites[other]);
          row.emplace_back(other, 0.5 * weight * (far * far - near * near) / (between * between));
        }
      }
    }
    return Status::Success();
  }

private:
  const PoissonSystem& System;
  const std::vector<Id>& Sites;
  const std::vector<Id>& Cells;
  Groups Vertices;           // per cell
  std::vector<double> Radii; // per site
};

Status FindDistances(const PoissonSystem& system, const std::vector<Id>& vertices,
  const ProgressCallback& progress, ExactResult& result)
{
  std::vector<GeodesicSource> sources;
  sources.reserve(vertices.size());
  for (const Id v : vertices)
  {
    sources.push_back({ SurfacePoint::AtVertex(v), 0.0 });
  }
  ExactOptions options;
  options.Progress = progress;
  ExactGeodesics exact(system.GetMesh());
  return exact.Run(sources, options, result);
}

/// Computes the nearest site of each vertex, and the distance from it.
Status FindPartition(const PoissonSystem& system, const std::vector<Id>& sites,
  const ProgressCallback& progress, std::vector<Id>& cells, std::vector<double>& distances)
{
  ExactResult result;
  DGG_RETURN_IF_ERROR(FindDistances(system, sites, progress, result));
  cells = std::move(result.NearestSource);
  distances = std::move(result.Distances);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    if (!IsInACell(system, v))
    {
      cells[v] = NoId;
    }
    else if (cells[v] == NoId)
    {
      return InvalidInput("No site reaches vertex ", v).Fix("Add a site there");
    }
  }
  return Status::Success();
}

/// Computes the fluxes to given values.
Status FindRims(const PoissonSystem& system, const ProgressCallback& progress, SplineCells& cells)
{
  std::vector<Id> given;
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    if (system.IsFixed(v))
    {
      given.push_back(v);
    }
  }
  if (given.empty())
  {
    return Status::Success();
  }
  ExactResult result;
  DGG_RETURN_IF_ERROR(FindDistances(system, given, progress, result));
  std::vector<double> means(cells.Weights.size(), 0.0);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    const Id cell = cells.Cells[v];
    if (cell != NoId)
    {
      means[cell] += system.GetWeight(v) / cells.Weights[cell] * result.Distances[v];
    }
  }
  for (const Id v : given)
  {
    for (Entries entry(system.GetStiffness(), v); entry; ++entry)
    {
      const Id u = static_cast<Id>(entry.row());
      const Id cell = cells.Cells[u];
      if (cell != NoId)
      {
        cells.Rims.push_back({ cell, v, -entry.value() * result.Distances[u] / means[cell] });
      }
    }
  }
  return Status::Success();
}

/// Assembles the matrix of coefficients, with the row sums on the diagonal.
void Assemble(std::size_t count, Triplets& conductances, SplineCells& cells)
{
  std::vector<double> sums(count, 0.0);
  Eigen::SparseMatrix<double>& matrix = cells.Stiffness;
  for (std::size_t i = 0; i < count; ++i)
  {
    conductances.emplace_back(static_cast<int>(i), static_cast<int>(i), 0.0);
  }
  matrix.resize(static_cast<int>(count), static_cast<int>(count));
  matrix.setFromTriplets(conductances.begin(), conductances.end());
  for (int column = 0; column < matrix.cols(); ++column)
  {
    for (Entries entry(matrix, column); entry; ++entry)
    {
      sums[column] -= entry.value();
    }
  }
  for (const SplineCells::Rim& rim : cells.Rims)
  {
    sums[rim.Site] += rim.Coefficient;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    matrix.coeffRef(static_cast<int>(i), static_cast<int>(i)) = sums[i];
  }
}

/// Sets the coefficients to the weights of the edges, their values if every vertex is a site.
void TakeWeights(const PoissonSystem& system, const SplineCells& cells, Triplets& conductances)
{
  const Eigen::SparseMatrix<double>& stiffness = system.GetStiffness();
  for (int u = 0; u < stiffness.cols(); ++u)
  {
    for (Entries entry(stiffness, u); entry && cells.Cells[u] != NoId; ++entry)
    {
      const auto v = entry.row();
      if (v != u && cells.Cells[v] != NoId)
      {
        conductances.emplace_back(cells.Cells[u], cells.Cells[v], entry.value());
      }
    }
  }
}

void Measure(const PoissonSystem& system, const std::vector<Id>& sites, SplineCells& cells)
{
  cells.Weights.assign(sites.size(), 0.0);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    if (cells.Cells[v] != NoId)
    {
      cells.Weights[cells.Cells[v]] += system.GetWeight(v);
    }
  }
  for (const Id site : sites)
  {
    cells.Components.push_back(system.GetComponent(site));
  }
}

Status FindCoefficients(const PoissonSystem& system, const std::vector<Id>& sites,
  const std::vector<Id>& cells, const std::vector<double>& distances, const ParallelFor& parallel,
  const ProgressCallback& progress, Triplets& conductances)
{
  CellFluxes fluxes(system, sites, cells);
  fluxes.FindRadii(distances);
  std::vector<SiteRow> rows(sites.size());
  DGG_RETURN_IF_ERROR(ForBlocks(
    static_cast<Offset>(sites.size()), 1, parallel, progress,
    [&] { return ExactGeodesics(system.GetMesh()); },
    [&](ExactGeodesics& exact, Offset site, Offset, Offset, const ProgressCallback& within) {
      return fluxes.Run(static_cast<std::size_t>(site), within, exact, rows[site]);
    }));
  std::size_t count = 0;
  for (const SiteRow& row : rows)
  {
    count += row.size();
  }
  conductances.reserve(2 * count + sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    for (const auto& [j, value] : rows[i])
    {
      conductances.emplace_back(static_cast<int>(i), j, -value);
      conductances.emplace_back(j, static_cast<int>(i), -value);
    }
  }
  return Status::Success();
}
}

Status FindSplineCells(const PoissonSystem& system, const std::vector<Id>& sites,
  const ParallelFor& parallel, const ProgressCallback& progress, SplineCells& cells)
{
  cells = SplineCells();
  std::size_t inCells = 0;
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    inCells += IsInACell(system, v) ? 1 : 0;
  }
  SplineCells found;
  Triplets conductances;
  std::vector<double> distances;
  const bool isWhole = sites.size() == inCells; // every vertex is a site
  if (isWhole)
  {
    found.Cells.assign(system.GetNumberOfVertices(), NoId);
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      found.Cells[sites[i]] = static_cast<Id>(i);
    }
  }
  else
  {
    DGG_RETURN_IF_ERROR(FindPartition(
      system, sites, ProgressPart(progress, 0.0, PartitionDone), found.Cells, distances));
  }
  Measure(system, sites, found);
  DGG_RETURN_IF_ERROR(FindRims(system, ProgressPart(progress, PartitionDone, RimsDone), found));
  if (isWhole)
  {
    TakeWeights(system, found, conductances);
  }
  else
  {
    DGG_RETURN_IF_ERROR(FindCoefficients(system, sites, found.Cells, distances, parallel,
      ProgressPart(progress, RimsDone, 1.0), conductances));
  }
  Assemble(sites.size(), conductances, found);
  DGG_RETURN_IF_ERROR(ReportTo(progress, 1.0));
  cells = std::move(found);
  return Status::Success();
}

bool SolveSiteEquations(const PoissonSystem& system, const SplineCells& cells,
  const std::vector<double>& rightHandSide, const std::vector<Id>& given,
  std::vector<double>& coefficients)
{
  const auto count = static_cast<Id>(cells.Components.size());
  std::vector<std::uint8_t> isKnown(cells.Components.size(), 0);
  std::vector<std::uint8_t> isFloating(system.GetNumberOfComponents(), 0); // no given values
  std::vector<double> values(cells.Components.size(), 0.0);
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(count);
  for (Id c = 0; c < system.GetNumberOfComponents(); ++c)
  {
    isFloating[c] = system.IsFree(c) ? 1 : 0;
  }
  for (const Id site : given)
  {
    values[site] = coefficients[site];
    isKnown[site] = 1;
    isFloating[cells.Components[site]] = 0;
  }
  for (std::size_t v = 0; v < rightHandSide.size(); ++v)
  {
    if (cells.Cells[v] != NoId)
    {
      sources[cells.Cells[v]] += rightHandSide[v];
    }
  }
  for (const SplineCells::Rim& rim : cells.Rims)
  {
    sources[rim.Site] += rim.Coefficient * rightHandSide[rim.Vertex];
  }
  // In components without given values, sources are balanced, and one value is fixed at 0 until the
  // mean is known.
  std::vector<double> totals(isFloating.size(), 0.0);
  for (Id i = 0; i < count; ++i)
  {
    totals[cells.Components[i]] += sources[i];
  }
  std::vector<std::uint8_t> isPinned(isFloating.size(), 0);
  for (Id i = 0; i < count; ++i)
  {
    const Id c = cells.Components[i];
    sources[i] -= isFloating[c] ? totals[c] * cells.Weights[i] : 0.0;
    isKnown[i] = isKnown[i] || (isFloating[c] && !isPinned[c]) ? 1 : 0;
    isPinned[c] = 1;
  }
  // Replace rows and columns of known values by rows and columns of the identity.
  Eigen::SparseMatrix<double> matrix = cells.Stiffness;
  for (int column = 0; column < matrix.cols(); ++column)
  {
    for (Entries entry(matrix, column); entry; ++entry)
    {
      const auto row = entry.row();
      if (isKnown[column] && !isKnown[row])
      {
        sources[row] -= entry.value() * values[column];
      }
      if (isKnown[column] || isKnown[row])
      {
        entry.valueRef() = row == column ? 1.0 : 0.0;
      }
    }
  }
  for (Id i = 0; i < count; ++i)
  {
    sources[i] = isKnown[i] ? values[i] : sources[i];
  }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success)
  {
    return false;
  }
  // Borders through obtuse triangles may have negative lengths, so that K is indefinite. There is
  // no pivoting: a step of refinement corrects the effect of small pivots, or the check fails.
  Eigen::VectorXd solution = factor.solve(sources);
  Eigen::VectorXd residual = sources - matrix * solution;
  solution += factor.solve(residual);
  residual = sources - matrix * solution;
  // If the matrix is singular up to rounding, values are so large that they cancel.
  const Eigen::VectorXd sizes = matrix.cwiseAbs() * solution.cwiseAbs();
  const double rounding = std::numeric_limits<double>::epsilon() * sizes.lpNorm<Eigen::Infinity>();
  const bool isSolved = solution.allFinite() &&
    residual.lpNorm<Eigen::Infinity>() <= Tolerance * sources.lpNorm<Eigen::Infinity>() &&
    rounding <= Tolerance * sources.lpNorm<1>();
  coefficients.assign(solution.data(), solution.data() + solution.size());
  std::vector<double> means(isFloating.size(), 0.0);
  for (Id i = 0; i < count; ++i)
  {
    means[cells.Components[i]] += cells.Weights[i] * coefficients[i];
  }
  for (Id i = 0; i < count; ++i)
  {
    const Id c = cells.Components[i];
    coefficients[i] -= isFloating[c] ? means[c] : 0.0;
  }
  return isSolved;
}
}
