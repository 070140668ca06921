// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact geodesic distance from one vertex to all: our engine, CGAL (if found) and the edge graph
/// of VTK, in one run.
///
/// Usage: BenchmarkExact [--benchmark_...] [--growth=FILE|none] [--cgal_limit=N] [mesh...]
///
/// Meshes may also be named by the environment (DGG_BENCHMARK_MESHES, separated by ':'). By
/// default, a generated surface and, if installed, the bunny of Debian's glmark2-data are measured.
/// The growth of engine T is measured on coarser and finer versions (quadric decimation, Loop
/// subdivision; 5K to about 700K vertices) of the mesh of --growth, by default the last mesh. CGAL
/// is not run above the limit of vertices, by default 60000.
///
/// Each line of the result is one source of one mesh, so that peers alternate within a mesh and
/// other load on the machine affects them equally. Times are CPU seconds of this process; the
/// set-up of each peer's mesh is reported separately ("SetUp" lines). summarize.py makes a table of
/// the result.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
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

/// Registers meshes of 5K, 10K and 20K vertices, the mesh itself, and one and two subdivisions.
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
