// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactCases.h"

#include "BenchmarkTools.h"
#include "dggExactGeodesics.h"

#include <memory>
#include <utility>

void MeasureSetUp(benchmark::State& state, const MeshRecipe& recipe)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  const MeshArrays& arrays = mesh.GetArrays();
  const auto build = [&](dgg::SurfaceMesh& surface) {
    dgg::SurfaceMesh::FromPoints(arrays.Points.data(),
      static_cast<dgg::Offset>(arrays.GetNumberOfVertices()), arrays.Triangles.data(),
      static_cast<dgg::Offset>(arrays.GetNumberOfFaces()), surface);
  };
  dgg::SurfaceMesh surface;
  Measure(
    state, [&] { surface = dgg::SurfaceMesh(); }, [&] { build(surface); });
  ReportMesh(state, mesh);
  state.counters["mesh_bytes_per_vertex"] =
    static_cast<double>(surface.GetMemorySize()) / mesh.GetNumberOfVertices();
  surface = dgg::SurfaceMesh();
  const MemoryProbe probe;
  build(surface);
  ReportMemory(state, mesh, probe);
}

void MeasureEngine(benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  const dgg::Id source = mesh.GetSource(k, numberOfSources);
  const std::vector<dgg::GeodesicSource> sources = { { dgg::SurfacePoint::AtVertex(source), 0.0 } };
  dgg::ExactResult result;
  std::unique_ptr<dgg::ExactGeodesics> solver;
  // A new solver for each run, because the first run of a user has no warm buffers either.
  Measure(
    state,
    [&] {
      solver = std::make_unique<dgg::ExactGeodesics>(mesh.GetSurface());
      result = dgg::ExactResult();
    },
    [&] { solver->Run(sources, {}, result); });
  ReportMesh(state, mesh);
  state.counters["windows"] = static_cast<double>(result.NumberOfWindows);
  state.counters["windows_per_second"] = benchmark::Counter(
    static_cast<double>(result.NumberOfWindows) * static_cast<double>(state.iterations()),
    benchmark::Counter::kIsRate);
  state.counters["engine_bytes_per_vertex"] =
    static_cast<double>(result.PeakMemory) / mesh.GetNumberOfVertices();

  mesh.SetExactDistances(source, std::move(result.Distances));
  // Memory is measured in a separate run. One source suffices where runs are long.
  if (k == 0 || mesh.GetNumberOfVertices() < 2e5)
  {
    solver.reset();
    result = dgg::ExactResult();
    const MemoryProbe probe;
    dgg::ExactGeodesics(mesh.GetSurface()).Run(sources, {}, result);
    ReportMemory(state, mesh, probe);
  }
}
