// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpectralCases.h"

#include "BenchmarkTools.h"
#include "OpenedSolver.h"
#include "dggEarthMovers.h"
#include "dggEigenpairs.h"

#include <memory>
#include <optional>
#include <vector>

namespace
{
constexpr unsigned int PointSeed = 20190525u;
}

void MeasureFactor(benchmark::State& state, const MeshRecipe& recipe)
{
  const BenchmarkMesh& mesh = OpenMesh(recipe);
  std::unique_ptr<dgg::PoissonSolver> solver;
  dgg::Status status;
  double analysis = 0.0;
  const auto prepare = [&] {
    const double start = CPUSeconds();
    solver = std::make_unique<dgg::PoissonSolver>(mesh.GetSurface());
    status = solver->Prepare({}, nullptr, [&](double, double) {
      analysis = CPUSeconds() - start;
      return dgg::Status::Success();
    });
  };
  Measure(
    state, [&] { solver.reset(); }, prepare);
  Require(status);
  ReportMesh(state, mesh);
  state.counters["analysis_seconds"] = analysis;
  state.counters["factor_entries"] = static_cast<double>(solver->GetNumberOfFactorEntries());
  // Memory is measured in a separate run. The prediction is for the factorization, after the
  // analysis.
  solver.reset();
  const MemoryProbe probe;
  std::size_t analyzed = 0;
  std::optional<MemoryProbe> later;
  solver = std::make_unique<dgg::PoissonSolver>(mesh.GetSurface());
  solver->Prepare({}, nullptr, [&](double bytes, double) {
    state.counters["analysis_bytes"] = static_cast<double>(probe.GetHeapPeak());
    state.counters["predicted_bytes"] = bytes;
    analyzed = probe.GetHeapGrowth();
    later.emplace();
    return dgg::Status::Success();
  });
  state.counters["peak_bytes"] = static_cast<double>(analyzed + later->GetHeapPeak());
}

void MeasureColumn(benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources)
{
  const OpenedSolver opened = OpenSolver(recipe);
  const std::vector<double> load =
    UnitLoad(*opened.Solver, opened.Mesh->GetSource(k, numberOfSources));
  std::vector<double> values;
  dgg::Status status;
  Measure(
    state, [&] { values = load; }, [&] { status = opened.Solver->Solve(values); });
  Require(status);
  ReportMesh(state, *opened.Mesh);
}

void MeasureColumnBlock(benchmark::State& state, const MeshRecipe& recipe)
{
  const OpenedSolver opened = OpenSolver(recipe);
  constexpr int Count = dgg::GreensFunction::PolesInBlock;
  const dgg::GreensFunction function(*opened.Solver);
  std::vector<dgg::SurfacePoint> poles;
  for (int k = 0; k < Count; ++k)
  {
    poles.push_back(dgg::SurfacePoint::AtVertex(opened.Mesh->GetSource(k, Count)));
  }
  dgg::GreensQuery query;
  query.Method = dgg::GreensMethod::Vertex;
  std::vector<dgg::GreensResult> results;
  dgg::Status status;
  Measure(
    state, [&] { results.clear(); }, [&] { status = function.Run(poles, query, results); });
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["columns"] = Count;
}

void MeasureGreens(benchmark::State& state, const MeshRecipe& recipe, const GreensWay& way, int k,
  int numberOfSources)
{
  const OpenedSolver opened = OpenSolver(recipe);
  const dgg::SurfaceMesh& surface = opened.Mesh->GetSurface();
  const dgg::SurfacePoint pole = RandomPoints(surface, numberOfSources, false, PointSeed)[k];
  MeasuredGreens greens(*opened.Solver, way);
  dgg::GreensResult result;
  const double start = CPUSeconds();
  dgg::Status status = greens.Run(pole, result);
  const double first = CPUSeconds() - start;
  Measure(
    state, [] {}, [&] { status = greens.Run(pole, result); });
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["first_seconds"] = first;
  state.counters["radius_in_edges"] = result.Radius / surface.GetMeanEdgeLength();
  state.counters["other_method"] = result.Method == way.Method ? 0.0 : 1.0;
  state.counters["near_ridge"] = result.Remark == dgg::GreensRemark::NearRidge ? 1.0 : 0.0;
}

void MeasureBiharmonicColumn(
  benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources)
{
  const OpenedSolver opened = OpenSolver(recipe);
  dgg::Status status;
  const dgg::Id source = opened.Mesh->GetSource(k, numberOfSources);
  std::vector<double> values;
  Measure(
    state, [&] { values.clear(); },
    [&] { status = FindColumn(*opened.Solver, source, 2, values); });
  Require(status);
  ReportMesh(state, *opened.Mesh);
}

void MeasureEigenpairs(benchmark::State& state, const MeshRecipe& recipe, int count)
{
  const OpenedSolver opened = OpenSolver(recipe);
  std::vector<dgg::Eigenpairs> pairs;
  dgg::Status status;
  Measure(
    state, [&] { pairs.clear(); },
    [&] { status = dgg::FindEigenpairs(*opened.Solver, count, nullptr, pairs); });
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["pairs"] = pairs.front().GetCount();
  state.counters["complete"] = pairs.front().IsComplete ? 1.0 : 0.0;
}

void MeasureEarthMovers(benchmark::State& state, const MeshRecipe& recipe)
{
  const OpenedSolver opened = OpenSolver(recipe);
  const dgg::Id here = opened.Mesh->GetSource(0, 2);
  const dgg::Id there = opened.Mesh->GetSource(1, 2);
  const std::vector<double> from = UnitLoad(*opened.Solver, here);
  const std::vector<double> to = UnitLoad(*opened.Solver, there);
  const dgg::EarthMovers movers(*opened.Solver);
  dgg::EarthMoversResult result;
  dgg::Status status;
  std::size_t peak = 0;
  Measure(
    state, [&] { result = dgg::EarthMoversResult(); },
    [&] {
      const MemoryProbe probe;
      status = movers.Run(from, to, {}, result);
      peak = probe.GetHeapPeak();
    });
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["iterations"] = result.Iterations;
  state.counters["gap"] = (result.Distance - result.LowerBound) / result.Distance;
  state.counters["per_geodesic"] = result.Distance / opened.Mesh->GetExactDistances(here)[there];
  state.counters["heap_bytes_per_vertex"] =
    static_cast<double>(peak) / opened.Mesh->GetNumberOfVertices();
}
