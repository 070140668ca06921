// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Green's functions of the bi-Laplacian, from Green's functions of the Laplacian: L q = M g. With
// GreensMethod::SingularitySubtraction, g = s + r enters with the integrals of the logarithm s. The
// function S, whose Laplacian is -s up to a smooth function, is subtracted from q.
#include "dggGreensColumn.h"

namespace dgg
{
GreensQuery GetFirstQuery(const GreensQuery& query)
{
  GreensQuery first = query;
  if (query.Order == GreensOrder::BiLaplace)
  {
    first.Sign = GreensSign::Positive;
    first.WantIntegrals = true;
  }
  return first;
}

void RaiseOrder(const PoissonSystem& system, const GreensQuery& query,
  const std::vector<GreensColumn>& columns, GreensResult* results)
{
  std::vector<std::vector<double>> solutions;
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    solutions.push_back(columns[k].TakeSecondSources(results[k]));
  }
  system.Solve(solutions);
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    columns[k].FinishSecond(solutions[k], results[k]);
    for (Id v = 0; v < system.GetNumberOfVertices() && query.WantIntegrals; ++v)
    {
      results[k].Integrals.push_back(system.GetArea(v) * results[k].Values[v]);
    }
  }
}

std::vector<double> GreensColumn::TakeSecondSources(GreensResult& result) const
{
  std::vector<double> sources;
  sources.swap(result.Integrals);
  for (Id v = 0; v < this->System.GetNumberOfVertices(); ++v)
  {
    if (this->System.IsFixed(v))
    {
      sources[v] = this->HasLogarithm() ? -this->Singular.PotentialAt(this->Distances[v]) : 0.0;
    }
  }
  std::vector<double>().swap(result.Values); // freed before further allocations
  return sources;
}

void GreensColumn::FinishSecond(std::vector<double>& solution, GreensResult& result) const
{
  const PoissonSystem& system = this->System;
  for (std::size_t k = 0; k < result.TargetValues.size(); ++k)
  {
    result.TargetValues[k] = InterpolateAt(system.GetMesh(), this->Query.Targets[k], solution) +
      (this->HasLogarithm() ? this->Singular.PotentialAt(this->TargetDistances[k]) : 0.0);
  }
  double mean = 0.0;
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    solution[v] += this->HasLogarithm() ? this->Singular.PotentialAt(this->Distances[v]) : 0.0;
    const bool isHere = system.GetComponent(v) == this->Component;
    mean += isHere && system.IsFree(this->Component) ? system.GetWeight(v) * solution[v] : 0.0;
  }
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    solution[v] -= system.GetComponent(v) == this->Component ? mean : 0.0;
  }
  for (std::size_t k = 0; k < result.TargetValues.size(); ++k)
  {
    result.TargetValues[k] -=
      system.GetComponent(this->Query.Targets[k]) == this->Component ? mean : 0.0;
  }
  result.Values.swap(solution);
}
}
