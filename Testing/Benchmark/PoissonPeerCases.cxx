// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PoissonPeerCases.h"

#include "BenchmarkTools.h"
#include "OpenedSolver.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr const char* Refusal = "the peer could not factorize or solve";

/// Returns a factorized solver. Only the last one is kept.
PeerPoisson* GetPrepared(
  const MeshRecipe& recipe, const BenchmarkMesh& mesh, const PoissonPeer& peer)
{
  static std::unique_ptr<PeerPoisson> kept;
  static std::string name;
  const std::string wanted = recipe.Name + "/" + peer.Name;
  if (!kept || name != wanted)
  {
    kept.reset(); // release before the next is allocated
    kept = peer.Make(mesh.GetArrays());
    name = wanted;
    if (!kept->Prepare())
    {
      kept.reset();
    }
  }
  return kept.get();
}

/// Returns the largest difference up to a constant, relative to the largest value.
double DifferenceOf(const dgg::PoissonSolver& solver, const std::vector<double>& ours,
  const std::vector<double>& theirs)
{
  double shift = 0.0;
  for (std::size_t v = 0; v < ours.size(); ++v)
  {
    shift += solver.GetWeight(static_cast<dgg::Id>(v)) * (theirs[v] - ours[v]);
  }
  double difference = 0.0;
  double size = 0.0;
  for (std::size_t v = 0; v < ours.size(); ++v)
  {
    difference = std::max(difference, std::abs(theirs[v] - shift - ours[v]));
    size = std::max(size, std::abs(ours[v]));
  }
  return difference / size;
}
}

std::vector<PoissonPeer> ListPoissonPeers()
{
  std::vector<PoissonPeer> peers;
#ifdef DGG_WITH_CHOLMOD
  peers.push_back({ "Cholmod", 1, MakePeerCholmod });
#endif
#ifdef DGG_WITH_LIBIGL
  for (const int power : { 1, 2 })
  {
    peers.push_back({ power == 1 ? "Libigl" : "LibiglBiharmonic", power,
      [power](const MeshArrays& mesh) { return MakePeerLibigl(mesh, power); } });
  }
#endif
  return peers;
}

void MeasurePeerFactor(benchmark::State& state, const MeshRecipe& recipe, const PoissonPeer& peer)
{
  const BenchmarkMesh& mesh = OpenMesh(recipe);
  bool isPrepared = false;
  std::unique_ptr<PeerPoisson> solver;
  Measure(
    state,
    [&] {
      solver.reset();
      solver = peer.Make(mesh.GetArrays());
    },
    [&] { isPrepared = solver->Prepare(); });
  Require(isPrepared, Refusal);
  ReportMesh(state, mesh);
  solver.reset();
  solver = peer.Make(mesh.GetArrays());
  const MemoryProbe probe;
  solver->Prepare();
  state.counters["peak_bytes"] = static_cast<double>(probe.GetHeapPeak());
}

void MeasurePeerColumn(benchmark::State& state, const MeshRecipe& recipe, const PoissonPeer& peer,
  int k, int numberOfSources)
{
  const OpenedSolver opened = OpenSolver(recipe);
  PeerPoisson* solver = GetPrepared(recipe, *opened.Mesh, peer);
  const dgg::Id source = opened.Mesh->GetSource(k, numberOfSources);
  std::vector<double> sources;
  for (dgg::Id v = 0; v < opened.Mesh->GetSurface().GetNumberOfVertices(); ++v)
  {
    sources.push_back((v == source ? 1.0 : 0.0) - opened.Solver->GetWeight(v));
  }
  std::vector<double> theirs;
  bool isSolved = solver != nullptr;
  Measure(
    state, [&] { theirs.clear(); }, [&] { isSolved = isSolved && solver->Solve(sources, theirs); });
  Require(isSolved, Refusal);
  std::vector<double> ours;
  Require(FindColumn(*opened.Solver, source, peer.Power, ours));
  ReportMesh(state, *opened.Mesh);
  state.counters["difference"] = DifferenceOf(*opened.Solver, ours, theirs);
}
