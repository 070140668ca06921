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
