// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldMethods.h"

#include "BenchmarkTools.h"
#include "PeerVTK.h"
#include "dggExactGeodesics.h"
#ifdef DGG_WITH_CGAL
#include "PeerCGAL.h"
#endif
#include "dggFastMarching.h"
#include "dggHeatMethod.h"

#include <memory>
#include <optional>
#include <utility>

namespace
{
std::vector<dgg::GeodesicSource> SourcesAt(dgg::Id vertex)
{
  return { { dgg::SurfacePoint::AtVertex(vertex), 0.0 } };
}

/// Returns the method after its preparation. Only the last one is kept.
const FieldMethod& GetPrepared(
  const MeshRecipe& recipe, const BenchmarkMesh& mesh, const NamedMethod& method)
{
  static std::optional<FieldMethod> kept;
  static std::string name;
  const std::string wanted = recipe.Name + "/" + method.Name;
  if (!kept || name != wanted)
  {
    kept.reset(); // release before the next is allocated
    FieldMethod made = method.Make(mesh);
    made.Prepare();
    kept = std::move(made);
    name = wanted;
  }
  return *kept;
}
}

NamedMethod HeatOfOurs()
{
  return { "Heat", [](const BenchmarkMesh& mesh) {
            const auto heat = std::make_shared<dgg::HeatMethod>(mesh.GetSurface());
            const auto result = std::make_shared<dgg::HeatResult>();
            return FieldMethod{ [heat] { Require(heat->Prepare({}, nullptr)); },
              [=](dgg::Id source) { Require(heat->Run(SourcesAt(source), {}, *result)); },
              [result] { return std::move(result->Distances); } };
          } };
}

NamedMethod MarchingOfOurs()
{
  return { "Marching", [](const BenchmarkMesh& mesh) {
            const auto marching = std::make_shared<std::unique_ptr<dgg::FastMarching>>();
            const auto result = std::make_shared<dgg::MarchingResult>();
            return FieldMethod{ [=, &mesh] {
                                 *marching = std::make_unique<dgg::FastMarching>(mesh.GetSurface());
                               },
              [=](dgg::Id source) { Require((*marching)->Run(SourcesAt(source), {}, *result)); },
              [result] { return std::move(result->Distances); } };
          } };
}

NamedMethod EdgesOfVTK()
{
  return { "VTK",
    [](const BenchmarkMesh& mesh) {
      const auto peer = std::make_shared<PeerVTK>(mesh.GetPolyData());
      return FieldMethod{ [] {}, [peer](dgg::Id source) { peer->Run(source); },
        [peer] { return peer->GetDistances(); } };
    },
    false };
}

#ifdef DGG_WITH_CGAL
NamedMethod ExactOfCGAL()
{
  return { "CGAL",
    [](const BenchmarkMesh& mesh) {
      const auto peer = std::make_shared<PeerCGAL>(mesh.GetArrays());
      const auto distances = std::make_shared<std::vector<double>>();
      Require(peer->GetRefusal());
      return FieldMethod{ [] {},
        [=](dgg::Id source) {
          peer->SetSourceVertex(source);
          *distances = peer->ComputeDistances();
        },
        [=] {
          peer->SetSourceVertex(0); // frees the tree of the run
          return std::move(*distances);
        } };
    },
    false };
}
#endif

#ifdef DGG_WITH_HEAT
NamedMethod HeatOfCGAL(PeerHeat::Triangulation triangulation)
{
  const bool isDirect = triangulation == PeerHeat::Triangulation::Direct;
  return { isDirect ? "HeatDirect" : "HeatDelaunay", [triangulation](const BenchmarkMesh& mesh) {
            const auto peer = std::make_shared<PeerHeat>(mesh.GetArrays(), triangulation);
            const auto check = [peer] { Require(peer->GetRefusal()); };
            return FieldMethod{ [=] {
                                 peer->Precompute();
                                 check();
                               },
              [=](dgg::Id source) {
                peer->Run(source);
                check();
              },
              [peer] { return peer->GetDistances(); } };
          } };
}
#endif

void MeasurePreparation(
  benchmark::State& state, const MeshRecipe& recipe, const NamedMethod& method)
{
  const BenchmarkMesh& mesh = OpenMesh(recipe);
  FieldMethod made;
  const auto make = [&] {
    made = FieldMethod(); // release before the next is allocated
    made = method.Make(mesh);
  };
  Measure(state, make, [&] { made.Prepare(); });
  ReportMesh(state, mesh);
  make();
  const MemoryProbe probe;
  made.Prepare();
  ReportMemory(state, mesh, probe);
}

void MeasureField(benchmark::State& state, const MeshRecipe& recipe, const NamedMethod& method,
  double limit, int k, int numberOfSources)
{
  BenchmarkMesh& mesh = OpenMesh(recipe, limit);
  const FieldMethod& prepared = GetPrepared(recipe, mesh, method);
  const dgg::Id source = mesh.GetSource(k, numberOfSources);
  if (method.IsPrepared)
  {
    prepared.Run(source);
  }
  const MemoryProbe probe;
  Measure(
    state, [] {}, [&] { prepared.Run(source); });
  ReportMemory(state, mesh, probe);
  ReportMesh(state, mesh);
  ReportErrors(state, mesh, source, prepared.TakeDistances());
}

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
