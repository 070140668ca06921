// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HeatCases.h"

#include "BenchmarkTools.h"

namespace
{
/// False, with the state closed, when the heat method refused the mesh.
bool Works(benchmark::State& state, const PeerHeat& peer)
{
  if (!peer.GetRefusal().empty())
  {
    state.SkipWithError(peer.GetRefusal().c_str());
  }
  return peer.GetRefusal().empty();
}
}

void MeasureHeatPrecomputation(
  benchmark::State& state, const MeshRecipe& recipe, PeerHeat::Triangulation triangulation)
{
  BenchmarkMesh* mesh = OpenMesh(state, recipe);
  if (!mesh)
  {
    return;
  }
  PeerHeat& peer = mesh->GetPeerHeat(triangulation);
  Measure(
    state, [&] { peer.Clear(); }, [&] { peer.Precompute(); });
  if (!Works(state, peer))
  {
    return;
  }
  ReportMesh(state, *mesh);
  peer.Clear();
  const MemoryProbe probe;
  peer.Precompute();
  ReportMemory(state, *mesh, probe);
}

void MeasureHeatQuery(benchmark::State& state, const MeshRecipe& recipe,
  PeerHeat::Triangulation triangulation, int k, int numberOfSources)
{
  BenchmarkMesh* mesh = OpenMesh(state, recipe);
  if (!mesh)
  {
    return;
  }
  PeerHeat& peer = mesh->GetPeerHeat(triangulation);
  const dgg::Id source = mesh->GetSource(k, numberOfSources);
  peer.Run(source); // not the first query
  Measure(
    state, [] {}, [&] { peer.Run(source); });
  if (!Works(state, peer))
  {
    return;
  }
  ReportMesh(state, *mesh);
  ReportErrors(state, *mesh, source, peer.GetDistances());
}
