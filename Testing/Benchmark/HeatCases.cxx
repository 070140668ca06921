// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeatCases.h"

#include "BenchmarkTools.h"

void MeasureHeatPrecomputation(
  benchmark::State& state, const MeshRecipe& recipe, PeerHeat::Triangulation triangulation)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  PeerHeat& peer = mesh.GetPeerHeat(triangulation);
  Measure(
    state, [&] { peer.Clear(); }, [&] { peer.Precompute(); });
  Require(peer.GetRefusal());
  ReportMesh(state, mesh);
  peer.Clear();
  const MemoryProbe probe;
  peer.Precompute();
  ReportMemory(state, mesh, probe);
}

void MeasureHeatQuery(benchmark::State& state, const MeshRecipe& recipe,
  PeerHeat::Triangulation triangulation, int k, int numberOfSources)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  PeerHeat& peer = mesh.GetPeerHeat(triangulation);
  const dgg::Id source = mesh.GetSource(k, numberOfSources);
  peer.Run(source); // not the first query
  Measure(
    state, [] {}, [&] { peer.Run(source); });
  Require(peer.GetRefusal());
  ReportMesh(state, mesh);
  ReportErrors(state, mesh, source, peer.GetDistances());
}
