// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenedSolver.h"

#include "BenchmarkTools.h"
#include "OpenedGraph.h"

#include <memory>
#include <string>

OpenedSolver OpenSolver(benchmark::State& state, const MeshRecipe& recipe)
{
  static std::unique_ptr<dgg::PoissonSolver> kept;
  static std::string name;
  OpenedSolver opened;
  if (kept && name != recipe.Name)
  {
    kept.reset(); // before its mesh goes, and the next one needs the memory
  }
  opened.Mesh = OpenMesh(state, recipe);
  if (!opened.Mesh)
  {
    return opened;
  }
  if (!kept)
  {
    kept = std::make_unique<dgg::PoissonSolver>(opened.Mesh->GetSurface());
    name = recipe.Name;
    if (!Succeeded(state, kept->Prepare({}, nullptr)))
    {
      kept.reset();
    }
  }
  opened.Solver = kept.get();
  return opened;
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
