// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSiteEquations.h"

#include "dggBlockLoop.h"
#include "dggGreensColumn.h"
#include "dggStatus.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Smallest reciprocal condition number; functions with a smaller one are treated as linearly
/// dependent.
constexpr double LeastCondition = 1e-14;
/// Maximum residual, relative to the range of values; residual from which on refinement stops; and
/// maximum number of refinement steps.
constexpr double LargestError = 1e-9;
constexpr double GoodError = 1e-13;
constexpr int MostSteps = 4;

Status TooLarge()
{
  return InvalidInput("The values of the sites are too large").Fix("Divide the values by a number");
}
}

Status SiteEquations::Prepare(
  const std::vector<SurfacePoint>& sites, const Eigen::MatrixXd& atSites)
{
  this->Sites = sites;
  this->Scales = atSites.cwiseAbs().colwise().maxCoeff().transpose();
  const bool isKnown = this->Scales.allFinite() && this->Scales.minCoeff() > 0.0;
  if (isKnown)
  {
    this->Factor.compute(atSites * this->Scales.cwiseInverse().asDiagonal());
  }
  return isKnown && this->Factor.rcond() > LeastCondition
    ? Status::Success()
    : InvalidInput("The values at the sites are linearly dependent")
        .Fix("Remove sites that are close to each other, or refine the mesh around them");
}

Status SiteEquations::CheckValues(const std::vector<std::vector<double>>& siteValues) const
{
  for (const std::vector<double>& values : siteValues)
  {
    if (values.size() != this->Sites.size())
    {
      return InvalidInput("There are ", values.size(), " values for ", this->Sites.size(), " sites")
        .Fix("Give one value per site");
    }
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (!std::isfinite(values[i]))
      {
        return InvalidInput("The value of site ", i, " is ", values[i]).Fix("Use finite values");
      }
    }
  }
  return Status::Success();
}

/// Returns, per component, the value of its first site if constants are free.
std::vector<double> SiteEquations::FindConstants(const std::vector<double>& values) const
{
  std::vector<double> constants(this->System.GetNumberOfComponents(), 0.0);
  for (std::size_t i = this->Sites.size(); i-- > 0;)
  {
    const Id component = this->System.GetComponent(this->Sites[i]);
    constants[component] = this->System.IsFree(component) ? values[i] : 0.0;
  }
  return constants;
}

Status SiteEquations::Solve(const std::vector<std::vector<double>>& siteValues,
  const Combine& combine, const ParallelFor& parallel, const ProgressCallback& progress,
  std::vector<std::vector<double>>& functions) const
{
  functions.clear();
  DGG_RETURN_IF_ERROR(this->CheckValues(siteValues));
  std::vector<std::vector<double>> all(siteValues.size());
  DGG_RETURN_IF_ERROR(ForBlocks(static_cast<Offset>(all.size()), SparseLanes::SizeAtCompileTime,
    parallel, progress, [&](Offset, Offset begin, Offset end, const ProgressCallback& within) {
      std::vector<std::vector<double>> found(static_cast<std::size_t>(end - begin));
      DGG_RETURN_IF_ERROR(this->SolveBlock(begin, siteValues, combine, within, found));
      std::move(found.begin(), found.end(), all.begin() + begin);
      return Status::Success();
    }));
  functions.swap(all);
  return Status::Success();
}

/// Solves for a block of functions, as many as in `found`, from column `begin` on.
Status SiteEquations::SolveBlock(Offset begin, const std::vector<std::vector<double>>& siteValues,
  const Combine& combine, const ProgressCallback& progress,
  std::vector<std::vector<double>>& found) const
{
  const auto count = static_cast<Eigen::Index>(this->Sites.size());
  const auto width = static_cast<Eigen::Index>(found.size());
  const auto n = static_cast<std::size_t>(this->System.GetNumberOfVertices());
  std::vector<std::vector<double>> constants;
  Eigen::MatrixXd wanted(count, width);
  Eigen::RowVectorXd sizes = Eigen::RowVectorXd::Ones(width);
  for (Eigen::Index c = 0; c < width; ++c)
  {
    const std::vector<double>& values = siteValues[begin + c];
    constants.push_back(this->FindConstants(values));
    for (Eigen::Index i = 0; i < count; ++i)
    {
      wanted(i, c) = values[i] - constants[c][this->System.GetComponent(this->Sites[i])];
    }
    const double size = wanted.col(c).cwiseAbs().maxCoeff();
    if (!std::isfinite(size))
    {
      return TooLarge();
    }
    sizes[c] = size > 0.0 ? size : 1.0;
    wanted.col(c) /= sizes[c];
  }
  for (std::vector<double>& function : found)
  {
    function.assign(n, 0.0);
  }
  Eigen::MatrixXd missing = wanted;
  double error = missing.size() > 0 ? missing.cwiseAbs().maxCoeff() : 0.0;
  for (int step = 0; step < MostSteps && error > GoodError; ++step)
  {
    const Eigen::MatrixXd solution =
      this->Scales.cwiseInverse().asDiagonal() * this->Factor.solve(missing);
    std::vector<std::vector<double>> columns;
    for (Eigen::Index c = 0; c < width; ++c)
    {
      columns.emplace_back(solution.col(c).data(), solution.col(c).data() + count);
    }
    DGG_RETURN_IF_ERROR(combine(columns));
    for (Eigen::Index c = 0; c < width; ++c)
    {
      for (std::size_t v = 0; v < n; ++v)
      {
        found[c][v] += columns[c][v];
      }
      for (Eigen::Index i = 0; i < count; ++i)
      {
        missing(i, c) =
          wanted(i, c) - InterpolateAt(this->System.GetMesh(), this->Sites[i], found[c]);
      }
    }
    error = missing.allFinite() ? missing.cwiseAbs().maxCoeff() : Infinity;
    DGG_RETURN_IF_ERROR(ReportTo(progress, (step + 1.0) / (MostSteps + 1.0)));
  }
  if (!(error <= LargestError))
  {
    return InvalidInput("The values at the sites could not be met to 1e-9")
      .Fix("Remove sites that are close to each other, or refine the mesh around them");
  }
  for (Eigen::Index c = 0; c < width; ++c)
  {
    for (std::size_t v = 0; v < n; ++v)
    {
      const Id component = this->System.GetComponent(static_cast<Id>(v));
      found[c][v] = found[c][v] * sizes[c] + constants[c][component];
      if (!std::isfinite(found[c][v])) // may exceed the range of site values
      {
        return TooLarge();
      }
    }
  }
  return Status::Success();
}
}
