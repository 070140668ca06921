// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ApproximateCases.h"

#include "BenchmarkTools.h"
#include "dggFastMarching.h"
#include "dggHeatMethod.h"

#include <memory>
#include <string>

namespace
{
std::vector<dgg::GeodesicSource> SourcesAt(dgg::Id vertex)
{
  return { { dgg::SurfacePoint::AtVertex(vertex), 0.0 } };
}

dgg::Status Prepare(const BenchmarkMesh& mesh, std::unique_ptr<dgg::HeatMethod>& heat)
{
  heat = std::make_unique<dgg::HeatMethod>(mesh.GetSurface());
  return heat->Prepare({}, nullptr);
}

/// Prepared, as long as no other mesh is asked for.
dgg::HeatMethod& GetHeatMethod(const MeshRecipe& recipe, const BenchmarkMesh& mesh)
{
  static std::unique_ptr<dgg::HeatMethod> kept;
  static std::string name;
  if (!kept || name != recipe.Name)
  {
    kept.reset(); // before the next one needs the memory
    Prepare(mesh, kept);
    name = recipe.Name;
  }
  return *kept;
}
}

void MeasureHeatFactors(benchmark::State& state, const MeshRecipe& recipe)
{
  const BenchmarkMesh& mesh = OpenMesh(recipe);
  std::unique_ptr<dgg::HeatMethod> heat;
  dgg::Status status;
  Measure(
    state, [&] { heat.reset(); }, [&] { status = Prepare(mesh, heat); });
  Require(status);
  ReportMesh(state, mesh);
  heat.reset();
  const MemoryProbe probe;
  Prepare(mesh, heat);
  ReportMemory(state, mesh, probe);
}

void MeasureHeatField(benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  const dgg::HeatMethod& heat = GetHeatMethod(recipe, mesh);
  const dgg::Id source = mesh.GetSource(k, numberOfSources);
  dgg::HeatResult result;
  dgg::Status status = heat.Run(SourcesAt(source), {}, result); // not the first query
  Measure(
    state, [] {}, [&] { status = heat.Run(SourcesAt(source), {}, result); });
  Require(status);
  ReportMesh(state, mesh);
  ReportErrors(state, mesh, source, result.Distances);
}

void MeasureMarchingTables(benchmark::State& state, const MeshRecipe& recipe)
{
  const BenchmarkMesh& mesh = OpenMesh(recipe);
  std::unique_ptr<dgg::FastMarching> marching;
  const auto make = [&] { marching = std::make_unique<dgg::FastMarching>(mesh.GetSurface()); };
  Measure(
    state, [&] { marching.reset(); }, make);
  ReportMesh(state, mesh);
  marching.reset();
  const MemoryProbe probe;
  make();
  ReportMemory(state, mesh, probe);
}

void MeasureMarchingField(
  benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  const dgg::FastMarching marching(mesh.GetSurface());
  const dgg::Id source = mesh.GetSource(k, numberOfSources);
  dgg::MarchingResult result;
  dgg::Status status = marching.Run(SourcesAt(source), {}, result); // not the first query
  Measure(
    state, [] {}, [&] { status = marching.Run(SourcesAt(source), {}, result); });
  Require(status);
  ReportMesh(state, mesh);
  ReportErrors(state, mesh, source, result.Distances);
}
