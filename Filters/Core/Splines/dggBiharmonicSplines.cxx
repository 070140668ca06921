// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBiharmonicSplines.h"

#include "dggBlockLoop.h"
#include "dggGeodesicSource.h"
#include "dggGreensColumn.h"
#include "dggPoissonSystem.h"
#include "dggSiteEquations.h"
#include "dggSplineSites.h"
#include "dggStatus.h"

#include <cstdint>

namespace dgg
{
namespace
{
/// Number of functions solved together.
constexpr Offset BlockSize = SparseLanes::SizeAtCompileTime;
/// Progress before the dense matrix is factorized.
constexpr double SolvesDone = 0.9;
/// Squared biharmonic distance of coincident sites, relative to its terms.
constexpr double SamePlace = 1e-13;
}

class BiharmonicSplines::Implementation
{
public:
  explicit Implementation(const PoissonSolver& solver)
    : Solver(solver)
    , System(solver.GetSystem())
    , Equations(solver.GetSystem())
  {
  }

  Status Check() const
  {
    return CheckPreparedSites(this->System, this->Sites.size(), this->Revision);
  }

  void AddLoad(const SurfacePoint& site, double weight, std::vector<double>& sources) const
  {
    ForEachCornerAround(this->System.GetMesh(), site,
      [&](Id v, double part, double) { sources[v] += weight * part; });
  }

  /// Returns, per site, the first site of its component if the component has constants, whose
  /// function is 1; NoId otherwise.
  std::vector<Id> FindFirst(const std::vector<SurfacePoint>& sites) const
  {
    std::vector<Id> ofComponents(this->System.GetNumberOfComponents(), NoId);
    std::vector<Id> first;
    for (const SurfacePoint& site : sites)
    {
      const Id c = this->System.GetComponent(site);
      Id& known = ofComponents[c];
      known = known == NoId && this->System.IsFree(c) ? static_cast<Id>(first.size()) : known;
      first.push_back(known);
    }
    return first;
  }

  /// Computes the Green's functions of all sites at all sites, with loads that are linear in faces.
  /// The matrix is symmetric. Single sites, whose function is 1, are skipped: such sites may lie
  /// where triangles are too thin.
  Status FindGreens(const std::vector<SurfacePoint>& sites, const std::vector<Id>& first,
    const ParallelFor& parallel, const ProgressCallback& progress, Eigen::MatrixXd& greens) const
  {
    std::vector<std::uint8_t> isSingle(sites.size(), 1);
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      const bool isFirst = first[i] == static_cast<Id>(i);
      isSingle[i] = isFirst ? isSingle[i] : 0;
      if (first[i] != NoId && !isFirst)
      {
        isSingle[first[i]] = 0;
      }
    }
    std::vector<Id> needed;
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      if (isSingle[i] == 0)
      {
        needed.push_back(static_cast<Id>(i));
      }
    }
    const auto size = static_cast<Eigen::Index>(sites.size());
    greens = Eigen::MatrixXd::Zero(size, size);
    return ForBlocks(static_cast<Offset>(needed.size()), BlockSize, parallel, progress,
      [&](Offset, Offset begin, Offset end, const ProgressCallback&) {
        std::vector<std::vector<double>> columns;
        for (Offset k = begin; k < end; ++k)
        {
          columns.emplace_back(this->System.GetNumberOfVertices(), 0.0);
          this->AddLoad(sites[needed[k]], 1.0, columns.back());
        }
        this->System.SolveBiLaplace(columns);
        for (Offset k = begin; k < end; ++k)
        {
          for (Eigen::Index i = 0; i < size; ++i)
          {
            greens(i, needed[k]) =
              InterpolateAt(this->System.GetMesh(), sites[i], columns[k - begin]);
          }
        }
        return Status::Success();
      });
  }

  Status CheckPlaces(const Eigen::MatrixXd& greens) const
  {
    for (Eigen::Index j = 0; j < greens.cols(); ++j)
    {
      for (Eigen::Index i = 0; i < j; ++i)
      {
        const double self = greens(i, i) + greens(j, j);
        if (self > 0.0 && !(self - greens(i, j) - greens(j, i) > SamePlace * self))
        {
          return InvalidInput("Site ", j, " has the same position as site ", i)
            .Fix("Remove one of them");
        }
      }
    }
    return Status::Success();
  }

  /// Returns the matrix of the functions at the sites: 1 for first sites, for others the Green's
  /// function minus the Green's function of the first site.
  Eigen::MatrixXd MakeMatrix(const std::vector<SurfacePoint>& sites, const std::vector<Id>& first,
    const Eigen::MatrixXd& greens) const
  {
    Eigen::MatrixXd matrix = greens;
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
    {
      const Id f = first[j];
      if (f == NoId)
      {
        continue;
      }
      matrix.col(j) -= greens.col(f);
      for (Eigen::Index i = 0; i < matrix.rows() && f == j; ++i)
      {
        matrix(i, j) =
          this->System.GetComponent(sites[i]) == this->System.GetComponent(sites[j]) ? 1.0 : 0.0;
      }
    }
    return matrix;
  }

  /// Computes sums of these functions at vertices.
  Status Combine(std::vector<std::vector<double>>& columns) const
  {
    const Id n = this->System.GetNumberOfVertices();
    std::vector<std::vector<double>> constants;
    for (std::vector<double>& column : columns)
    {
      std::vector<double> weights = column;
      constants.emplace_back(this->System.GetNumberOfComponents(), 0.0);
      for (std::size_t j = 0; j < weights.size(); ++j)
      {
        if (this->First[j] == static_cast<Id>(j))
        {
          constants.back()[this->System.GetComponent(this->Sites[j])] = column[j];
          weights[j] = 0.0;
        }
        else if (this->First[j] != NoId)
        {
          weights[this->First[j]] -= column[j]; // comes before j
        }
      }
      column.assign(n, 0.0);
      for (std::size_t j = 0; j < weights.size(); ++j)
      {
        this->AddLoad(this->Sites[j], weights[j], column);
      }
    }
    this->System.SolveBiLaplace(columns);
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      for (Id v = 0; v < n; ++v)
      {
        columns[c][v] += constants[c][this->System.GetComponent(v)];
      }
    }
    return Status::Success();
  }

  const PoissonSolver& Solver;
  const PoissonSystem& System;
  SiteEquations Equations;
  std::vector<SurfacePoint> Sites;
  std::vector<Id> First;
  std::uint64_t Revision = 0; // revision of the prepared system
};

BiharmonicSplines::BiharmonicSplines(const PoissonSolver& solver)
  : Internals(std::make_unique<Implementation>(solver))
{
}

BiharmonicSplines::~BiharmonicSplines() = default;

Status BiharmonicSplines::Prepare(const std::vector<SurfacePoint>& sites,
  const ParallelFor& parallel, const ProgressCallback& progress)
{
  Implementation& internals = *this->Internals;
  internals.Sites.clear();
  DGG_RETURN_IF_ERROR(CheckSplinePlaces(internals.Solver, sites));
  const std::vector<Id> first = internals.FindFirst(sites);
  Eigen::MatrixXd greens;
  DGG_RETURN_IF_ERROR(
    internals.FindGreens(sites, first, parallel, ProgressPart(progress, 0.0, SolvesDone), greens));
  DGG_RETURN_IF_ERROR(internals.CheckPlaces(greens));
  DGG_RETURN_IF_ERROR(
    internals.Equations.Prepare(sites, internals.MakeMatrix(sites, first, greens)));
  DGG_RETURN_IF_ERROR(ReportTo(progress, 1.0));
  internals.Sites = sites;
  internals.First = first;
  internals.Revision = internals.System.GetRevision();
  return Status::Success();
}

Status BiharmonicSplines::Interpolate(const std::vector<std::vector<double>>& siteValues,
  const ParallelFor& parallel, const ProgressCallback& progress,
  std::vector<std::vector<double>>& functions) const
{
  functions.clear();
  const Implementation& internals = *this->Internals;
  DGG_RETURN_IF_ERROR(internals.Check());
  return internals.Equations.Solve(
    siteValues, [&](auto& columns) { return internals.Combine(columns); }, parallel, progress,
    functions);
}

Status BiharmonicSplines::FindBasis(const ParallelFor& parallel, const ProgressCallback& progress,
  const HarmonicSplines::Consumer& consume) const
{
  DGG_RETURN_IF_ERROR(this->Internals->Check());
  const std::size_t count = this->Internals->Sites.size();
  return ForBlocks(static_cast<Offset>(count), BlockSize, parallel, progress,
    [&](Offset, Offset begin, Offset end, const ProgressCallback& within) {
      std::vector<std::vector<double>> values;
      for (Offset site = begin; site < end; ++site)
      {
        values.emplace_back(count, 0.0);
        values.back()[site] = 1.0;
      }
      std::vector<std::vector<double>> functions;
      DGG_RETURN_IF_ERROR(this->Interpolate(values, nullptr, within, functions));
      for (Offset site = begin; site < end; ++site)
      {
        consume(static_cast<Id>(site), functions[site - begin]);
      }
      return Status::Success();
    });
}
}
