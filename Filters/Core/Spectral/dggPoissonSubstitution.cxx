// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// How a factorized system is solved: sources balanced, substituted, refined, the solution centred.
#include "dggPoissonSystem.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dgg
{
namespace
{
/// Beyond this, entries are so different that substitutions have to be repeated.
constexpr double LargestHarmlessEntry = 1e3;
constexpr int MostRefinements = 20;
/// What may be left of the sources, relative to the largest of them and of the solution: both have
/// the same unit, and sources of 1 make values of about 1.
constexpr double GoodResidual = 1e-12;
/// What rounding may do to a solution besides, relative to its largest value: its last four bits.
constexpr double LastBits = 16.0 * std::numeric_limits<double>::epsilon();

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

std::vector<double> PoissonSystem::Multiply(const std::vector<double>& f) const
{
  std::vector<double> result(f.size(), 0.0);
  for (int column = 0; column < this->Stiffness.cols(); ++column)
  {
    // Differences, so that what is constant gives 0 to the last bit.
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
void PoissonSystem::CenterAll(std::vector<Number>& values) const
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

void PoissonSystem::Center(std::vector<double>& values) const
{
  this->CenterAll(values);
}

/// What flows from vertices whose values are given.
template <typename Number>
void PoissonSystem::TakeGivenValuesOff(std::vector<Number>& values) const
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
void PoissonSystem::Substitute(std::vector<Number>& values) const
{
  std::vector<Number> inOrder(values.size());
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    inOrder[this->Places[v]] = values[v];
  }
  for (const Id place : this->PinnedPlaces)
  {
    if (place != NoId)
    {
      inOrder[place] = MakeZero<Number>();
    }
  }
  this->Factor.Solve(inOrder);
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    values[v] = inOrder[this->Places[v]];
  }
}

template <typename Number>
void PoissonSystem::SolveOnce(std::vector<Number>& values) const
{
  this->Balance(values);
  this->TakeGivenValuesOff(values);
  this->Substitute(values);
  this->CenterAll(values);
}

/// Conjugate gradients with the factor as preconditioner: where the factor is good one step is
/// enough, where it had to be raised a few are. Residuals that the last bits of the solution make
/// are no reason for a step.
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
  this->CenterAll(solution);
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

void PoissonSystem::Solve(std::vector<SparseLanes>& values) const
{
  if (!this->NeedsRefinement())
  {
    this->SolveOnce(values);
    return;
  }
  std::vector<SparseLanes> sources = values;
  this->Balance(sources);
  this->SolveOnce(values);
  std::vector<double> source(values.size());
  std::vector<double> solution(values.size());
  for (int lane = 0; lane < SparseLanes::SizeAtCompileTime; ++lane)
  {
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      source[v] = sources[v][lane];
      solution[v] = values[v][lane];
    }
    this->Refine(source, solution);
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      values[v][lane] = solution[v];
    }
  }
}
}
