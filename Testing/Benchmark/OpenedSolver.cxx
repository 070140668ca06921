// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenedSolver.h"

#include "BenchmarkTools.h"

#include <memory>

OpenedSolver OpenSolver(const MeshRecipe& recipe)
{
  static std::unique_ptr<dgg::PoissonSolver> kept;
  static std::string name;
  if (kept && name != recipe.Name)
  {
    kept.reset(); // release before its mesh is released and the next is allocated
  }
  BenchmarkMesh& mesh = OpenMesh(recipe);
  if (!kept)
  {
    auto solver = std::make_unique<dgg::PoissonSolver>(mesh.GetSurface());
    Require(solver->Prepare({}, nullptr));
    kept = std::move(solver);
    name = recipe.Name;
  }
  return { &mesh, kept.get() };
}

std::vector<double> UnitLoad(const dgg::PoissonSolver& solver, dgg::Id vertex)
{
  std::vector<double> load(static_cast<std::size_t>(solver.GetMesh().GetNumberOfVertices()), 0.0);
  load[vertex] = 1.0;
  return load;
}

dgg::Status FindColumn(
  const dgg::PoissonSolver& solver, dgg::Id source, int power, std::vector<double>& values)
{
  values = UnitLoad(solver, source);
  dgg::Status status = solver.Solve(values);
  for (int k = 1; k < power && status.IsOk(); ++k)
  {
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      values[v] *= solver.GetAreas()[v];
    }
    status = solver.Solve(values);
  }
  return status;
}

const std::vector<GreensWay>& GetGreensWays()
{
  using dgg::GreensMethod;
  static const std::vector<GreensWay> ways = {
    { "SingularitySubtraction", GreensMethod::SingularitySubtraction, false },
    { "RegularPart", GreensMethod::SingularitySubtraction, true },
    { "Localized", GreensMethod::Localized, false },
    { "Interpolated", GreensMethod::Interpolated, false },
    { "Vertex", GreensMethod::Vertex, false },
  };
  return ways;
}

MeasuredGreens::MeasuredGreens(const dgg::PoissonSolver& solver, const GreensWay& way)
  : Way(way)
  , Function(solver)
  , Interpolation(solver)
{
}

dgg::Status MeasuredGreens::Run(const dgg::SurfacePoint& pole, dgg::GreensResult& result)
{
  dgg::GreensQuery query;
  query.Method = this->Way.Method;
  return this->Way.IsInterpolation ? this->Interpolation.Run(pole, query, result)
                                   : this->Function.Run(pole, query, result);
}
