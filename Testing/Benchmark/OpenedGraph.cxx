// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenedGraph.h"

#include "BenchmarkTools.h"

OpenedGraph OpenGraph(benchmark::State& state, const GraphRecipe& recipe)
{
  OpenedGraph opened;
  opened.Mesh = OpenMesh(state, recipe.Mesh);
  if (opened.Mesh)
  {
    opened.Graph = &opened.Mesh->GetGraph(recipe);
  }
  return opened;
}

OpenedGraph OpenBuiltGraph(benchmark::State& state, const GraphRecipe& recipe)
{
  OpenedGraph opened = OpenGraph(state, recipe);
  if (opened.Graph)
  {
    opened.Graph->NeedGraph();
    if (!opened.Graph->GetError().empty())
    {
      state.SkipWithError(opened.Graph->GetError().c_str());
      opened.Graph = nullptr;
    }
  }
  return opened;
}

bool Succeeded(benchmark::State& state, const dgg::Status& status)
{
  if (!status.IsOk())
  {
    state.SkipWithError(status.GetMessage().c_str());
  }
  return status.IsOk();
}
