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
///   Spectral/MESH/Greens/WAY/K      OpenedSolver.h
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
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace
{
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

void RegisterMesh(const MeshRecipe& mesh, const Settings& settings)
{
  const CaseGroup cases("Spectral/" + mesh.Name + "/");
  const int sources = settings.Sources;
  cases.Add("Factor", MeasureFactor, mesh);
  cases.AddSources("Column", sources, MeasureColumn, mesh);
  cases.Add("Block", MeasureColumnBlock, mesh);
  for (const GreensWay& way : GetGreensWays())
  {
    cases.AddSources("Greens/" + way.Name, sources, MeasureGreens, mesh, way);
  }
  cases.AddSources("Biharmonic", sources, MeasureBiharmonicColumn, mesh);
  if (settings.Eigenpairs > 0)
  {
    cases.For(Once).Add("Eigenpairs", MeasureEigenpairs, mesh, settings.Eigenpairs);
  }
  if (settings.Movers > 0)
  {
    cases.For(Once).Add("EarthMovers", MeasureEarthMovers, mesh);
  }
}

void RegisterPeers(const MeshRecipe& mesh, int sources)
{
  for (const PoissonPeer& peer : ListPoissonPeers())
  {
    const CaseGroup cases("Peer/" + mesh.Name + "/" + peer.Name + "/");
    cases.Add("Factor", MeasurePeerFactor, mesh, peer);
    cases.AddSources("Column", sources, MeasurePeerColumn, mesh, peer);
  }
#ifdef DGG_WITH_HEAT
  const auto direct = PeerHeat::Triangulation::Direct;
  const CaseGroup cases("Peer/" + mesh.Name + "/Heat/");
  cases.Add("Factor", MeasureHeatPrecomputation, mesh, direct);
  cases.AddSources("Column", sources, MeasureHeatQuery, mesh, direct);
#endif
}

/// A torus of about so many vertices.
MeshRecipe TorusOf(int size)
{
  MeshRecipe torus;
  torus.Rings = static_cast<int>(std::lround(std::sqrt(2.0 * size)));
  torus.Name = "torus-" + SizeName(size);
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

Settings ReadSettings(const BenchmarkArguments& arguments)
{
  Settings settings;
  settings.Sizes = arguments.GetIntegers("sizes");
  settings.Sources = arguments.GetInteger("sources");
  settings.Eigenpairs = arguments.GetInteger("eigenpairs");
  settings.Movers = arguments.GetInteger("movers");
  settings.Levels = arguments.GetIntegers("levels");
  settings.Poles = arguments.GetInteger("poles");
  settings.Splines = arguments.GetIntegers("splines");
  const auto areWithin = [](const std::vector<int>& values, int least, int most) {
    return std::all_of(
      values.begin(), values.end(), [=](int value) { return value >= least && value <= most; });
  };
  constexpr int Any = std::numeric_limits<int>::max();
  Require(areWithin(settings.Sizes, 100, Any) && areWithin(settings.Levels, 0, FinestLevel) &&
      areWithin(settings.Splines, 1, Any) && std::min(settings.Sources, settings.Poles) >= 1,
    "sizes must be at least 100, levels from 0 to " + std::to_string(FinestLevel) +
      ", sources, poles and splines at least 1");
  return settings;
}

void RegisterAll(const BenchmarkArguments& arguments)
{
  const Settings settings = ReadSettings(arguments);
  for (const MeshRecipe& mesh : ListMeshes(arguments, settings))
  {
    RegisterMesh(mesh, settings);
    RegisterPeers(mesh, settings.Sources);
  }
  for (const int level : settings.Levels)
  {
    for (const GreensWay& way : GetGreensWays())
    {
      CaseGroup("Convergence/" + std::to_string(level) + "/", Once)
        .Add(way.Name, MeasureConvergence, level, way, settings.Poles);
    }
  }
  for (const int sites : settings.Splines)
  {
    CaseGroup("Splines/", Once).Add(std::to_string(sites), MeasureSplines, LevelOfSplines, sites);
  }
#ifdef DGG_WITH_CHOLMOD
  benchmark::AddCustomContext("cholmod_version", DGG_BENCHMARK_CHOLMOD);
#endif
}
}

int main(int argc, char** argv)
{
  return RunBenchmarks(argc, argv,
    { { "sizes", "35000,100000" }, { "sources", "5" }, { "eigenpairs", "100" }, { "movers", "1" },
      { "levels", "3,4,5,6" }, { "poles", "10" }, { "splines", "80,320,1280" } },
    RegisterAll);
}
