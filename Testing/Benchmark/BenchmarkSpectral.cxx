// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Green's functions and their applications: times of factorizations, of columns, of sources at any
/// surface point by each method, of biharmonic columns, eigenpairs and an earth mover's distance;
/// compared with CHOLMOD, libigl and CGAL's heat method, as far as they were found, in one run.
///
/// Usage: BenchmarkSpectral [--benchmark_...] [--name=value...] [mesh...]
///   --sizes=35000,100000  vertices of generated tori; empty: none
///   --sources=5         of columns and Green's functions
///   --eigenpairs=100    number of eigenpairs; 0: none
///   --movers=1          number of earth mover's distances; 0: none
/// Meshes as for BenchmarkExact, without its generated surface. Peers need connected meshes.
///
/// Names of the results are
///   Spectral/MESH/CASE[/K]          SpectralCases.h
///   Spectral/MESH/Greens/WAY/K      OpenedSolver.h
///   Peer/MESH/PEER/CASE[/K]         PoissonPeerCases.h; FieldMethods.h for the peer Heat, which
///                                   has two matrices
/// Times are CPU seconds on one thread. summarize_spectral.py makes tables of the result.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "FieldMethods.h"
#include "PoissonPeerCases.h"
#include "SpectralCases.h"

#include <cmath>
#include <string>
#include <vector>

namespace
{
void RegisterMesh(const MeshRecipe& mesh, const BenchmarkArguments& arguments, int sources)
{
  const CaseGroup cases("Spectral/" + mesh.Name + "/");
  cases.Add("Factor", MeasureFactor, mesh);
  cases.AddSources("Column", sources, MeasureColumn, mesh);
  cases.Add("Block", MeasureColumnBlock, mesh);
  for (const GreensWay& way : GetGreensWays())
  {
    cases.AddSources("Greens/" + way.Name, sources, MeasureGreens, mesh, way);
  }
  cases.AddSources("Biharmonic", sources, MeasureBiharmonicColumn, mesh);
  if (const int pairs = arguments.GetInteger("eigenpairs"))
  {
    cases.For(Once).Add("Eigenpairs", MeasureEigenpairs, mesh, pairs);
  }
  if (arguments.GetInteger("movers") > 0)
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
  const NamedMethod direct = HeatOfCGAL(PeerHeat::Triangulation::Direct);
  const CaseGroup cases("Peer/" + mesh.Name + "/Heat/");
  cases.Add("Factor", MeasurePreparation, mesh, direct);
  cases.AddSources("Column", sources, MeasureField, mesh, direct, dgg::Infinity);
#endif
}

/// Returns the recipe of a torus with about `size` vertices.
MeshRecipe TorusOf(int size)
{
  MeshRecipe torus;
  torus.Rings = static_cast<int>(std::lround(std::sqrt(2.0 * size)));
  torus.Name = "torus-" + SizeName(size);
  return torus;
}

std::vector<MeshRecipe> ListMeshes(const BenchmarkArguments& arguments)
{
  std::vector<MeshRecipe> meshes;
  for (const int size : arguments.GetIntegers("sizes"))
  {
    Require(size >= 100, "sizes must be at least 100");
    meshes.push_back(TorusOf(size));
  }
  for (const MeshRecipe& mesh : arguments.GetMeshes())
  {
    if (!mesh.File.empty())
    {
      meshes.push_back(mesh);
    }
  }
  return meshes;
}

void RegisterAll(const BenchmarkArguments& arguments)
{
  const int sources = arguments.GetAtLeast("sources", 1);
  for (const MeshRecipe& mesh : ListMeshes(arguments))
  {
    RegisterMesh(mesh, arguments, sources);
    RegisterPeers(mesh, sources);
  }
#ifdef DGG_WITH_CHOLMOD
  benchmark::AddCustomContext("cholmod_version", DGG_BENCHMARK_CHOLMOD);
#endif
}
}

int main(int argc, char** argv)
{
  return RunBenchmarks(argc, argv,
    { { "sizes", "35000,100000" }, { "sources", "5" }, { "eigenpairs", "100" }, { "movers", "1" } },
    RegisterAll);
}
