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
#include <iostream>
#include <string>
#include <vector>

namespace
{
using State = benchmark::State;

/// One run is all that is timed: cases take the smallest of several times of their own.
constexpr double Once = 1e-9;

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

void RegisterTracing(
  const std::string& name, const IsolineRecipe& recipe, IsolineKind kind, const Settings& settings)
{
  const auto add = [&](const char* suffix, double chord) {
    RegisterCase(
      name + suffix, [=](State& state) { MeasureIsolines(state, recipe, kind, chord); }, Once);
  };
  add("", settings.Chord);
  if (recipe.Input == FieldInput::Exact)
  {
    add("Halved", 0.5 * settings.Chord);
    add("Drawn", settings.Drawn);
  }
}

void RegisterApollonius(
  const std::string& prefix, const IsolineRecipe& recipe, const std::vector<int>& steinerPoints)
{
  for (const int count : steinerPoints)
  {
    RegisterCase(
      prefix + "Apollonius" + std::to_string(count),
      [=](State& state) { MeasureApollonius(state, recipe, count); }, Once);
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
    const std::string prefix = "Isolines/" + mesh.Name + "/" + input.Name + "/";
    RegisterCase(
      prefix + "Input", [=](State& state) { MeasureInput(state, recipe); }, Once);
    RegisterCase(
      prefix + "Contour", [=](State& state) { MeasureContour(state, recipe); }, Once);
    if (input.Input == FieldInput::Exact)
    {
      RegisterTracing(prefix + "Windows", recipe, IsolineKind::Windows, settings);
      RegisterCase(
        prefix + "Fitted",
        [=](State& state) { MeasureIsolines(state, recipe, IsolineKind::Fitted, settings.Chord); },
        Once);
      RegisterApollonius(prefix, recipe, settings.SteinerPoints);
      if (withMore)
      {
        RegisterApollonius(prefix, recipe, settings.MoreSteinerPoints);
      }
    }
    RegisterTracing(prefix + "Sources", recipe, IsolineKind::Sources, settings);
  }
}

#ifdef DGG_WITH_HEAT
void RegisterPeer(const MeshRecipe& mesh, int sources)
{
  const auto triangulation = PeerHeat::Triangulation::IntrinsicDelaunay;
  const std::string prefix = "Peer/" + mesh.Name + "/Heat/";
  RegisterCase(prefix + "Factors",
    [=](State& state) { MeasureHeatPrecomputation(state, mesh, triangulation); });
  for (int k = 0; k < sources; ++k)
  {
    RegisterCase(prefix + "Query/" + std::to_string(k),
      [=](State& state) { MeasureHeatQuery(state, mesh, triangulation, k, sources); });
  }
}
#endif

void RegisterApproximate(const MeshRecipe& mesh, int sources)
{
  const std::string prefix = "Approximate/" + mesh.Name + "/";
  RegisterCase(prefix + "Heat/Factors", [=](State& state) { MeasureHeatFactors(state, mesh); });
  RegisterCase(
    prefix + "Marching/Tables", [=](State& state) { MeasureMarchingTables(state, mesh); });
  for (int k = 0; k < sources; ++k)
  {
    RegisterCase(prefix + "Heat/Query/" + std::to_string(k),
      [=](State& state) { MeasureHeatField(state, mesh, k, sources); });
    RegisterCase(prefix + "Marching/Query/" + std::to_string(k),
      [=](State& state) { MeasureMarchingField(state, mesh, k, sources); });
  }
#ifdef DGG_WITH_HEAT
  RegisterPeer(mesh, sources);
#endif
}

/// 5000 is 5K.
std::string SizeName(int size)
{
  return size % 1000 == 0 ? std::to_string(size / 1000) + "K" : std::to_string(size);
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

/// What was named, and the torus.
std::vector<MeshRecipe> ListMeshes(const BenchmarkArguments& arguments)
{
  std::vector<MeshRecipe> meshes = arguments.GetMeshes();
  const int rings = static_cast<int>(arguments.GetNumber("torus"));
  if (rings > 0)
  {
    MeshRecipe torus;
    torus.Name = "torus";
    torus.Rings = rings;
    meshes.push_back(torus);
  }
  return meshes;
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
      MeshRecipe finer = mesh;
      finer.Name += "-x4";
      finer.Subdivisions = 1;
      RegisterApproximate(finer, settings.Sources);
    }
  }
}

/// False, with a message, when the arguments make no sense.
bool ReadSettings(const BenchmarkArguments& arguments, Settings& settings)
{
  settings.Sizes = arguments.GetIntegers("sizes");
  settings.SteinerPoints = arguments.GetIntegers("steiner");
  settings.MoreSteinerPoints = arguments.GetIntegers("more_steiner");
  settings.Levels = static_cast<int>(arguments.GetNumber("levels"));
  settings.Chord = arguments.GetNumber("chord");
  settings.Drawn = arguments.GetNumber("drawn");
  settings.Accuracy = arguments.GetNumber("accuracy");
  settings.Sources = static_cast<int>(arguments.GetNumber("sources"));
  const bool hasSmall =
    std::any_of(settings.Sizes.begin(), settings.Sizes.end(), [](int size) { return size < 100; });
  if (hasSmall || settings.Levels < 1 || settings.Sources < 0)
  {
    std::cerr << "sizes must be at least 100, levels at least 1, sources at least 0\n";
    return false;
  }
  if (!(std::min({ settings.Chord, settings.Drawn, settings.Accuracy }) > 0.0))
  {
    std::cerr << "chord, drawn and accuracy must be positive\n";
    return false;
  }
  const int rings = static_cast<int>(arguments.GetNumber("torus"));
  if (rings != 0 && rings < 6)
  {
    std::cerr << "a torus has at least 6 rings\n";
    return false;
  }
  return true;
}
}

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  BenchmarkArguments arguments({ { "sizes", "600,1000,5000,10000,50000" }, { "levels", "20" },
    { "chord", "0.00001" }, { "drawn", "0.001" }, { "steiner", "0,2" },
    { "more_steiner", "1,5,10,20,50" }, { "accuracy", "0.01" }, { "sources", "3" },
    { "torus", "100" }, { "subdivided", "armadillo" } });
  Settings settings;
  if (!arguments.Parse(argc, argv) || !ReadSettings(arguments, settings))
  {
    return 1;
  }
  bool isFirst = true;
  for (const MeshRecipe& mesh : ListMeshes(arguments))
  {
    RegisterMesh(mesh, settings, arguments.GetList("subdivided"), isFirst);
    isFirst = false;
  }
  AddBenchmarkContext();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
