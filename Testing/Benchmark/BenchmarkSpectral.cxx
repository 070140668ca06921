// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Green's functions and what is made of them: the time of factorizations, of columns and of
/// sources anywhere by each method, of biharmonic columns, eigenpairs and an earth mover's
/// distance; beside CHOLMOD, libigl and CGAL's heat method, those of them that were found, in one
/// run. Then errors on spheres, where there is a closed form.
///
/// Usage: BenchmarkSpectral [--benchmark_...] [--name=value...] [mesh...]
///   --sizes=35000,100000  vertices of generated tori; empty leaves them out
///   --sources=5         of columns and Green's functions
///   --eigenpairs=100    0 leaves them out
///   --movers=1          earth mover's distances; 0 leaves them out
///   --levels=3,4,5,6    of icospheres for errors; empty leaves these out
///   --poles=10          on each of them
///   --splines=80,320,1280  sites of B-splines on a sphere; empty leaves these out
/// Meshes as for BenchmarkExact, but without its generated surface. Peers need connected ones.
///
/// Names of the results are
///   Spectral/MESH/CASE[/K]          SpectralCases.h
///   Spectral/MESH/Greens/WAY/K      MeasuredGreens.h
///   Peer/MESH/PEER/CASE[/K]         PoissonPeerCases.h; HeatCases.h for the peer Heat, which has
///                                   two matrices
///   Convergence/LEVEL/WAY           ConvergenceCases.h
///   Splines/SITES                   ConvergenceCases.h
/// Times are CPU seconds on one thread. summarize_spectral.py makes tables of it, plot_spectral.py
/// a plot.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "ConvergenceCases.h"
#include "PoissonPeerCases.h"
#include "SpectralCases.h"
#ifdef DGG_WITH_HEAT
#include "HeatCases.h"
#endif

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace
{
using State = benchmark::State;

/// One run is all that is timed of what takes long.
constexpr double Once = 1e-9;
constexpr int FinestLevel = 8;
constexpr int LevelOfSplines = 5;

struct Settings
{
  std::vector<int> Sizes;
  int Sources = 0;
  int Eigenpairs = 0;
  int Movers = 0;
  std::vector<int> Levels;
  int Poles = 0;
  std::vector<int> Splines;
};

/// Run a case for each of the sources.
template <class Run>
void RegisterForSources(const std::string& name, int sources, const Run& run)
{
  for (int k = 0; k < sources; ++k)
  {
    RegisterCase(name + "/" + std::to_string(k), [=](State& state) { run(state, k); });
  }
}

void RegisterMesh(const MeshRecipe& mesh, const Settings& settings)
{
  const std::string prefix = "Spectral/" + mesh.Name + "/";
  const int sources = settings.Sources;
  RegisterCase(prefix + "Factor", [=](State& state) { MeasureFactor(state, mesh); });
  RegisterForSources(prefix + "Column", sources,
    [=](State& state, int k) { MeasureColumn(state, mesh, k, sources); });
  RegisterCase(prefix + "Block", [=](State& state) { MeasureColumnBlock(state, mesh); });
  for (const GreensWay& way : GetGreensWays())
  {
    RegisterForSources(prefix + "Greens/" + way.Name, sources,
      [=](State& state, int k) { MeasureGreens(state, mesh, way, k, sources); });
  }
  RegisterForSources(prefix + "Biharmonic", sources,
    [=](State& state, int k) { MeasureBiharmonicColumn(state, mesh, k, sources); });
  if (settings.Eigenpairs > 0)
  {
    RegisterCase(
      prefix + "Eigenpairs",
      [=](State& state) { MeasureEigenpairs(state, mesh, settings.Eigenpairs); }, Once);
  }
  if (settings.Movers > 0)
  {
    RegisterCase(
      prefix + "EarthMovers", [=](State& state) { MeasureEarthMovers(state, mesh); }, Once);
  }
}

void RegisterPeers(const MeshRecipe& mesh, int sources)
{
  for (const PoissonPeer& peer : ListPoissonPeers())
  {
    const std::string prefix = "Peer/" + mesh.Name + "/" + peer.Name + "/";
    RegisterCase(prefix + "Factor", [=](State& state) { MeasurePeerFactor(state, mesh, peer); });
    RegisterForSources(prefix + "Column", sources,
      [=](State& state, int k) { MeasurePeerColumn(state, mesh, peer, k, sources); });
  }
#ifdef DGG_WITH_HEAT
  const auto direct = PeerHeat::Triangulation::Direct;
  const std::string prefix = "Peer/" + mesh.Name + "/Heat/";
  RegisterCase(
    prefix + "Factor", [=](State& state) { MeasureHeatPrecomputation(state, mesh, direct); });
  RegisterForSources(prefix + "Column", sources,
    [=](State& state, int k) { MeasureHeatQuery(state, mesh, direct, k, sources); });
#endif
}

void RegisterConvergence(const Settings& settings)
{
  for (const int level : settings.Levels)
  {
    for (const GreensWay& way : GetGreensWays())
    {
      RegisterCase(
        "Convergence/" + std::to_string(level) + "/" + way.Name,
        [=](State& state) { MeasureConvergence(state, level, way, settings.Poles); }, Once);
    }
  }
}

void RegisterSplines(const Settings& settings)
{
  for (const int sites : settings.Splines)
  {
    RegisterCase(
      "Splines/" + std::to_string(sites),
      [=](State& state) { MeasureSplines(state, LevelOfSplines, sites); }, Once);
  }
}

/// A torus of about so many vertices.
MeshRecipe TorusOf(int size)
{
  MeshRecipe torus;
  torus.Rings = static_cast<int>(std::lround(std::sqrt(2.0 * size)));
  torus.Name =
    "torus-" + (size % 1000 == 0 ? std::to_string(size / 1000) + "K" : std::to_string(size));
  return torus;
}

std::vector<MeshRecipe> ListMeshes(const BenchmarkArguments& arguments, const Settings& settings)
{
  std::vector<MeshRecipe> meshes;
  std::transform(settings.Sizes.begin(), settings.Sizes.end(), std::back_inserter(meshes), TorusOf);
  for (const MeshRecipe& mesh : arguments.GetMeshes())
  {
    if (!mesh.File.empty())
    {
      meshes.push_back(mesh);
    }
  }
  return meshes;
}

/// False, with a message, when the arguments make no sense.
bool ReadSettings(const BenchmarkArguments& arguments, Settings& settings)
{
  settings.Sizes = arguments.GetIntegers("sizes");
  settings.Sources = static_cast<int>(arguments.GetNumber("sources"));
  settings.Eigenpairs = static_cast<int>(arguments.GetNumber("eigenpairs"));
  settings.Movers = static_cast<int>(arguments.GetNumber("movers"));
  settings.Levels = arguments.GetIntegers("levels");
  settings.Poles = static_cast<int>(arguments.GetNumber("poles"));
  settings.Splines = arguments.GetIntegers("splines");
  const auto isNone = [](int count) { return count < 1; };
  const auto isSmall = [](int size) { return size < 100; };
  const auto isNoLevel = [](int level) { return level < 0 || level > FinestLevel; };
  if (std::any_of(settings.Sizes.begin(), settings.Sizes.end(), isSmall) ||
    std::any_of(settings.Levels.begin(), settings.Levels.end(), isNoLevel) ||
    std::any_of(settings.Splines.begin(), settings.Splines.end(), isNone) || settings.Sources < 1 ||
    settings.Poles < 1)
  {
    std::cerr << "sizes must be at least 100, levels from 0 to " << FinestLevel
              << ", sources, poles and splines at least 1\n";
    return false;
  }
  return true;
}
}

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  BenchmarkArguments arguments(
    { { "sizes", "35000,100000" }, { "sources", "5" }, { "eigenpairs", "100" }, { "movers", "1" },
      { "levels", "3,4,5,6" }, { "poles", "10" }, { "splines", "80,320,1280" } });
  Settings settings;
  if (!arguments.Parse(argc, argv) || !ReadSettings(arguments, settings))
  {
    return 1;
  }
  for (const MeshRecipe& mesh : ListMeshes(arguments, settings))
  {
    RegisterMesh(mesh, settings);
    RegisterPeers(mesh, settings.Sources);
  }
  RegisterConvergence(settings);
  RegisterSplines(settings);
  AddBenchmarkContext();
#ifdef DGG_WITH_CHOLMOD
  benchmark::AddCustomContext("cholmod_version", DGG_BENCHMARK_CHOLMOD);
#endif
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
