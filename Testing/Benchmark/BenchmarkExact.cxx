// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact geodesic distance from one vertex to all: our engine, CGAL (when it was found) and the
/// edge graph of VTK, in one run.
///
/// Usage: BenchmarkExact [--benchmark_...] [--growth=FILE|none] [--cgal_limit=N] [mesh...]
///
/// Meshes may also come from the environment (DGG_BENCHMARK_MESHES, separated by ':'). Without any,
/// a generated surface is measured, and the bunny of Debian's glmark2-data when it is installed.
/// The growth of engine T is followed over coarser and finer versions (quadric decimation, Loop
/// subdivision; 5K to about 700K vertices) of the mesh of --growth, by default the last mesh.
/// CGAL is left out above the limit of vertices, by default 60000.
///
/// Every line of the result is one source of one mesh, so that peers alternate within a mesh and a
/// busy machine disturbs them alike. Times are CPU seconds of this process, the set-up of each
/// peer's mesh apart ("SetUp" lines). summarize.py makes a table of it.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "ExactCases.h"
#include "FieldMethods.h"

namespace
{
constexpr int NumberOfSources = 5;

void RegisterComparison(const MeshRecipe& recipe, const BenchmarkArguments& arguments)
{
  const CaseGroup cases("Exact/" + recipe.Name + "/");
  cases.Add("SetUp", MeasureSetUp, recipe);
  for (int k = 0; k < NumberOfSources; ++k)
  {
    cases.AddSource("T", k, NumberOfSources, MeasureEngine, recipe);
    cases.AddSource("VTK", k, NumberOfSources, MeasureField, recipe, EdgesOfVTK(), dgg::Infinity);
#ifdef DGG_WITH_CGAL
    cases.AddSource("CGAL", k, NumberOfSources, MeasureField, recipe, ExactOfCGAL(),
      arguments.GetNumber("cgal_limit"));
#endif
  }
}

/// 5K, 10K, 20K, the mesh itself, and one and two subdivisions of it.
void RegisterGrowth(const MeshRecipe& base)
{
  std::vector<MeshRecipe> recipes;
  for (const int thousands : { 5, 10, 20 })
  {
    MeshRecipe recipe = base;
    recipe.Name += "-" + std::to_string(thousands) + "K";
    recipe.Vertices = 1000 * thousands;
    recipes.push_back(recipe);
  }
  recipes.push_back(base);
  for (const int steps : { 1, 2 })
  {
    MeshRecipe recipe = base;
    recipe.Name += "-x" + std::to_string(steps == 1 ? 4 : 16);
    recipe.Subdivisions = steps;
    recipes.push_back(recipe);
  }
  for (const MeshRecipe& recipe : recipes)
  {
    CaseGroup("Growth/" + recipe.Name + "/")
      .AddSources("T", NumberOfSources, MeasureEngine, recipe);
  }
}

void RegisterAll(const BenchmarkArguments& arguments)
{
  for (const MeshRecipe& recipe : arguments.GetMeshes())
  {
    RegisterComparison(recipe, arguments);
  }
  const std::string& growth = arguments.Get("growth");
  if (growth != "none")
  {
    RegisterGrowth(growth.empty() ? arguments.GetMeshes().back() : MeshFromFile(growth));
  }
}
}

int main(int argc, char** argv)
{
  return RunBenchmarks(argc, argv, { { "growth", "" }, { "cgal_limit", "60000" } }, RegisterAll);
}
