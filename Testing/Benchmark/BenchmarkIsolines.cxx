// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines of distances beside vtkContourFilter: their errors, times and memory; and the
/// approximate distances that isolines are drawn from beside CGAL's heat method (when it was
/// found), in one run.
///
/// Usage: BenchmarkIsolines [--benchmark_...] [--name=value...] [mesh...]
///   --sizes=600,1000,5000,10000,50000  vertices that meshes are brought to: decimated where they
///                       have more, and where they have at least a quarter of it, decimated to that
///                       and subdivided (Loop); empty leaves isolines out
///   --levels=20         isolines, evenly over the range of the exact distances
///   --chord=0.00001     how far lines may be from level sets where errors are measured, in mean
///                       edge lengths; half of that is measured as well, to show how much it
///                       matters
///   --drawn=0.001       the same for isolines of exact distances to be looked at: times are those
///   --steiner=0,2       points per edge of the published method
///   --more_steiner=1,5,10,20,50  the same in addition, on the first mesh at its smallest and its
///                       largest size
///   --accuracy=0.01     of the graph
///   --sources=3         of approximate distances, on meshes as they are; 0 leaves these out
///   --torus=100         rings of a generated torus; 0 leaves it out
///   --subdivided=armadillo  meshes whose approximate distances are measured after a step of Loop
///                       subdivision as well
/// Meshes as for BenchmarkExact.
///
/// Names of the results are GROUP/MESH/CASE with these groups:
///   Isolines/MESH-SIZE/INPUT/...  IsolineCases.h; the input is Exact, Graph, Heat or Marching
///   Approximate/MESH/...          ApproximateCases.h
///   Peer/MESH/...                 CGAL's heat method
/// Times are CPU seconds on one thread. summarize_isolines.py makes tables of it.

#include "ApproximateCases.h"
#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "IsolineCases.h"
#ifdef DGG_WITH_HEAT
#include "HeatCases.h"
#endif

#include <vtkPolyData.h>

#include <algorithm>
#include <string>
#include <vector>

namespace
{
struct Settings
{
  std::vector<int> Sizes;
  int Levels = 0;
  double Chord = 0.0;
  double Drawn = 0.0;
  double Accuracy = 0.0;
  int Sources = 0;
  std::vector<int> SteinerPoints;
  std::vector<int> MoreSteinerPoints;
};

struct NamedInput
{
  const char* Name;
  FieldInput Input;
};

const std::vector<NamedInput> Inputs = {
  { "Exact", FieldInput::Exact },
  { "Graph", FieldInput::Graph },
  { "Heat", FieldInput::Heat },
  { "Marching", FieldInput::Marching },
};

void RegisterTracing(const CaseGroup& cases, const std::string& name, const IsolineRecipe& recipe,
  IsolineKind kind, const Settings& settings)
{
  cases.Add(name, MeasureIsolines, recipe, kind, settings.Chord);
  if (recipe.Input == FieldInput::Exact)
  {
    cases.Add(name + "Halved", MeasureIsolines, recipe, kind, 0.5 * settings.Chord);
    cases.Add(name + "Drawn", MeasureIsolines, recipe, kind, settings.Drawn);
  }
}

void RegisterApollonius(
  const CaseGroup& cases, const IsolineRecipe& recipe, const std::vector<int>& steinerPoints)
{
  for (const int count : steinerPoints)
  {
    cases.Add("Apollonius" + std::to_string(count), MeasureApollonius, recipe, count);
  }
}

void RegisterIsolines(const MeshRecipe& mesh, const Settings& settings, bool withMore)
{
  for (const NamedInput& input : Inputs)
  {
    IsolineRecipe recipe;
    recipe.Mesh = mesh;
    recipe.Input = input.Input;
    recipe.Accuracy = settings.Accuracy;
    recipe.Levels = settings.Levels;
    const CaseGroup cases("Isolines/" + mesh.Name + "/" + input.Name + "/", Once);
    cases.Add("Input", MeasureInput, recipe);
    cases.Add("Contour", MeasureContour, recipe);
    if (input.Input == FieldInput::Exact)
    {
      RegisterTracing(cases, "Windows", recipe, IsolineKind::Windows, settings);
      cases.Add("Fitted", MeasureIsolines, recipe, IsolineKind::Fitted, settings.Chord);
      RegisterApollonius(cases, recipe, settings.SteinerPoints);
      if (withMore)
      {
        RegisterApollonius(cases, recipe, settings.MoreSteinerPoints);
      }
    }
    RegisterTracing(cases, "Sources", recipe, IsolineKind::Sources, settings);
  }
}

void RegisterApproximate(const MeshRecipe& mesh, int sources)
{
  const CaseGroup cases("Approximate/" + mesh.Name + "/");
  cases.Add("Heat/Factors", MeasureHeatFactors, mesh);
  cases.Add("Marching/Tables", MeasureMarchingTables, mesh);
  for (int k = 0; k < sources; ++k)
  {
    cases.AddSource("Heat/Query", k, sources, MeasureHeatField, mesh);
    cases.AddSource("Marching/Query", k, sources, MeasureMarchingField, mesh);
  }
#ifdef DGG_WITH_HEAT
  const CaseGroup peer("Peer/" + mesh.Name + "/Heat/");
  const auto triangulation = PeerHeat::Triangulation::IntrinsicDelaunay;
  peer.Add("Factors", MeasureHeatPrecomputation, mesh, triangulation);
  peer.AddSources("Query", sources, MeasureHeatQuery, mesh, triangulation);
#endif
}

/// A mesh at the sizes that it can be brought to.
std::vector<MeshRecipe> AtSizes(const MeshRecipe& mesh, const std::vector<int>& sizes)
{
  std::vector<MeshRecipe> found;
  if (sizes.empty())
  {
    return found;
  }
  const auto vertices = static_cast<int>(mesh.Make()->GetNumberOfPoints());
  for (const int size : sizes)
  {
    MeshRecipe recipe = mesh;
    recipe.Name += "-" + SizeName(size);
    if (vertices < size)
    {
      recipe.Subdivisions += 1;
    }
    const int wanted = vertices < size ? size / 4 : size;
    if (wanted <= vertices)
    {
      recipe.Vertices = wanted;
      found.push_back(recipe);
    }
  }
  return found;
}

void RegisterMesh(const MeshRecipe& mesh, const Settings& settings,
  const std::vector<std::string>& subdivided, bool isFirst)
{
  const std::vector<MeshRecipe> recipes = AtSizes(mesh, settings.Sizes);
  for (std::size_t i = 0; i < recipes.size(); ++i)
  {
    RegisterIsolines(recipes[i], settings, isFirst && (i == 0 || i + 1 == recipes.size()));
  }
  if (settings.Sources > 0)
  {
    RegisterApproximate(mesh, settings.Sources);
    if (std::find(subdivided.begin(), subdivided.end(), mesh.Name) != subdivided.end())
    {
      RegisterApproximate(Subdivided(mesh), settings.Sources);
    }
  }
}

Settings ReadSettings(const BenchmarkArguments& arguments)
{
  Settings settings;
  settings.Sizes = arguments.GetIntegers("sizes");
  settings.SteinerPoints = arguments.GetIntegers("steiner");
  settings.MoreSteinerPoints = arguments.GetIntegers("more_steiner");
  settings.Levels = arguments.GetInteger("levels");
  settings.Chord = arguments.GetNumber("chord");
  settings.Drawn = arguments.GetNumber("drawn");
  settings.Accuracy = arguments.GetNumber("accuracy");
  settings.Sources = arguments.GetInteger("sources");
  const bool hasSmall =
    std::any_of(settings.Sizes.begin(), settings.Sizes.end(), [](int size) { return size < 100; });
  Require(!hasSmall && settings.Levels >= 1 && settings.Sources >= 0,
    "sizes must be at least 100, levels at least 1, sources at least 0");
  Require(std::min({ settings.Chord, settings.Drawn, settings.Accuracy }) > 0.0,
    "chord, drawn and accuracy must be positive");
  return settings;
}

/// What was named, and the torus.
void RegisterAll(const BenchmarkArguments& arguments)
{
  const Settings settings = ReadSettings(arguments);
  std::vector<MeshRecipe> meshes = arguments.GetMeshes();
  if (arguments.GetInteger("torus") != 0)
  {
    meshes.push_back(TorusOfRings(arguments.GetInteger("torus")));
  }
  for (const MeshRecipe& mesh : meshes)
  {
    RegisterMesh(mesh, settings, arguments.GetList("subdivided"), &mesh == &meshes.front());
  }
}
}

int main(int argc, char** argv)
{
  return RunBenchmarks(argc, argv,
    { { "sizes", "600,1000,5000,10000,50000" }, { "levels", "20" }, { "chord", "0.00001" },
      { "drawn", "0.001" }, { "steiner", "0,2" }, { "more_steiner", "1,5,10,20,50" },
      { "accuracy", "0.01" }, { "sources", "3" }, { "torus", "100" },
      { "subdivided", "armadillo" } },
    RegisterAll);
}
