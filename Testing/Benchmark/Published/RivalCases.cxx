// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RivalCases.h"

#include "BenchmarkTools.h"
#include "MergingEngine.h"
#include "TriangleUnfolding.h"
#include "VariationalHeat.h"
#include "dggHeatMethod.h"
#include "dggPathFinder.h"

#include <cstdlib>
#include <fstream>

namespace
{
constexpr int PairsOfStart = 20;
constexpr double LeastSeconds = 0.05; // minimum total time of queries

/// Returns the CPU seconds of an exact propagation from a vertex.
double ExactSeconds(const BenchmarkMesh& mesh)
{
  dgg::ExactGeodesics solver(mesh.GetSurface());
  dgg::ExactResult result;
  const double start = ThreadSeconds();
  Require(solver.Run({ { dgg::SurfacePoint::AtVertex(mesh.GetSource(0, 1)), 0.0 } }, {}, result));
  return ThreadSeconds() - start;
}

/// Writes raw doubles, for maps.
void WriteField(const std::string& file, const std::vector<double>& field)
{
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(field.data()),
    static_cast<std::streamsize>(field.size() * sizeof(double)));
  Require(out.good(), "cannot write " + file);
}

void MeasureHeat(benchmark::State& state, const MeshRecipe& recipe, bool isDelaunay, int steps,
  int vertex, const std::string& file, int k, int numberOfSources)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  const dgg::SurfaceMesh& surface = mesh.GetSurface();
  const dgg::Id source = vertex >= 0 ? vertex : mesh.GetSource(k, numberOfSources);
  dgg::HeatOptions options;
  options.IntrinsicDelaunay = isDelaunay;
  dgg::HeatMethod heat(surface);
  Require(heat.Prepare(options, nullptr));
  VariationalHeat variational(surface);
  Require(variational.Prepare(isDelaunay));
  dgg::HeatResult result;
  dgg::Status status;
  Measure(
    state, [] {},
    [&] {
      status = heat.Run({ { dgg::SurfacePoint::AtVertex(source), 0.0 } }, {}, result);
      if (status.IsOk())
      {
        variational.Improve(source, steps, result.Distances);
      }
    });
  Require(status);
  ReportMesh(state, mesh);
  state.counters["energy"] = variational.Energy(result.Distances);
  ReportErrors(state, mesh, source, result.Distances);
  if (!file.empty())
  {
    WriteField(file, result.Distances);
  }
}

/// Queries all pairs; times are per pair.
template <typename Ask>
void MeasurePairs(
  benchmark::State& state, BenchmarkMesh& mesh, const PairRecipe& pairs, const Ask& ask)
{
  MeasuredPairs& measured = mesh.GetPairs(pairs);
  const std::vector<double>& exact = measured.GetExactDistances();
  ask(measured.GetStart(0), measured.GetEnd(0)); // the first query prepares data
  std::vector<double> lengths(measured.GetCount());
  double seconds = 0.0;
  double count = 0.0;
  while (seconds < LeastSeconds)
  {
    const double start = ThreadSeconds();
    for (std::size_t i = 0; i < lengths.size(); ++i)
    {
      lengths[i] = ask(measured.GetStart(i), measured.GetEnd(i));
    }
    seconds += ThreadSeconds() - start;
    count += static_cast<double>(lengths.size());
  }
  state.counters["query_seconds"] = seconds / count;
  state.counters["exact_seconds"] = ExactSeconds(mesh);
  ReportMesh(state, mesh);
  ReportErrors(state, ErrorStatistics::Of(lengths, exact));
}

void MeasureUnfolding(
  benchmark::State& state, const MeshRecipe& recipe, int samples, const PairRecipe& pairs)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  TriangleUnfolding unfolding(mesh.GetSurface());
  dgg::Status status;
  Measure(
    state, [] {}, [&] { status = unfolding.Prepare(samples); });
  Require(status);
  MeasurePairs(state, mesh, pairs, [&](const dgg::SurfacePoint& from, const dgg::SurfacePoint& to) {
    return unfolding.GetDistance(from.Vertex, to.Vertex);
  });
  state.counters["bytes"] = static_cast<double>(unfolding.GetMemorySize());
  state.counters["triangles"] = static_cast<double>(unfolding.GetNumberOfTriangles());
}

/// Measures lengths or straightened paths in the graph.
void MeasureGraphPairs(
  benchmark::State& state, const GraphRecipe& recipe, const PairRecipe& pairs, bool isStraightened)
{
  const OpenedGraph opened = OpenGraph(recipe);
  MeasuredGraph& graph = *opened.Graph;
  Measure(
    state, [&] { graph.Clear(); }, [&] { graph.Build(ThreadedLoop(1)); });
  Require(graph.GetError());
  const double* positions = opened.Mesh->GetArrays().Points.data();
  const dgg::GraphSearch& search = graph.GetSearch();
  const dgg::PathFinder finder(opened.Mesh->GetSurface(), search, nullptr, positions);
  dgg::GraphPath path;
  dgg::FoundPath found;
  MeasurePairs(
    state, *opened.Mesh, pairs, [&](const dgg::SurfacePoint& from, const dgg::SurfacePoint& to) {
      if (isStraightened)
      {
        Require(finder.Find(from, to, {}, found));
        return found.Path.IsEmpty() ? dgg::Infinity : found.Path.Length;
      }
      Require(search.Between(
        { dgg::GraphSeed{ from.Vertex } }, { dgg::GraphSeed{ to.Vertex } }, positions, path));
      return path.Length;
    });
  state.counters["bytes"] = static_cast<double>(graph.GetGraph().GetMemorySize());
}

/// Measures merged windows; with a tolerance of 0, the exact engine.
void MeasureMerging(
  benchmark::State& state, const MeshRecipe& recipe, double tolerance, int k, int numberOfSources)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  const dgg::Id source = mesh.GetSource(k, numberOfSources);
  const std::vector<dgg::GeodesicSource> sources{ { dgg::SurfacePoint::AtVertex(source), 0.0 } };
  dgg::ExactGeodesics exact(mesh.GetSurface());
  MergingEngine engine(mesh.GetSurface(), tolerance);
  dgg::ExactResult result;
  dgg::Status status;
  Measure(
    state, [] {},
    [&] {
      status = tolerance > 0.0 ? engine.Run(sources, dgg::ExactOptions(), result, false)
                               : exact.Run(sources, {}, result);
    });
  Require(status);
  ReportMesh(state, mesh);
  state.counters["windows_per_vertex"] =
    static_cast<double>(result.NumberOfWindows) / mesh.GetNumberOfVertices();
  state.counters["merged_per_vertex"] =
    static_cast<double>(engine.GetNumberOfMerged()) / mesh.GetNumberOfVertices();
  ReportErrors(state, mesh, source, result.Distances);
}
}

void RegisterHeat(const MeshRecipe& mesh, const BenchmarkArguments& arguments)
{
  const int vertex = arguments.GetInteger("vertex");
  const int sources = vertex >= 0 ? 1 : arguments.GetInteger("sources");
  for (const std::string triangles : { "Direct", "Delaunay" })
  {
    for (const int steps : arguments.GetIntegers("steps"))
    {
      const std::string name = triangles + "/steps=" + std::to_string(steps);
      std::string file = arguments.Get("fields");
      if (!file.empty())
      {
        file.append("/" + triangles + "-" + std::to_string(steps)).append(".raw");
      }
      CaseGroup("Published/" + mesh.Name + "/Heat/", Once)
        .AddSources(name, sources, MeasureHeat, mesh, triangles == "Delaunay", steps, vertex, file);
    }
  }
}

void RegisterUnfolding(const MeshRecipe& mesh, const BenchmarkArguments& arguments)
{
  PairRecipe pairs;
  pairs.Count = arguments.GetInteger("pairs");
  pairs.PerStart = PairsOfStart;
  pairs.AtVertices = true;
  const CaseGroup cases("Published/" + mesh.Name + "/Unfolding/", Once);
  for (const int samples : arguments.GetIntegers("samples"))
  {
    cases.Add("samples=" + std::to_string(samples), MeasureUnfolding, mesh, samples, pairs);
  }
  for (const std::string& text : arguments.GetList("accuracies"))
  {
    GraphRecipe recipe;
    recipe.Mesh = mesh;
    recipe.Name = "Guaranteed/" + text;
    recipe.Options.Accuracy = std::atof(text.c_str());
    cases.Add("Graph/" + text, MeasureGraphPairs, recipe, pairs, false);
    cases.Add("Paths/" + text, MeasureGraphPairs, recipe, pairs, true);
  }
}

void RegisterMerging(const MeshRecipe& mesh, const BenchmarkArguments& arguments)
{
  const CaseGroup cases("Published/" + mesh.Name + "/Merging/", Once);
  for (const std::string& text : arguments.GetList("tolerances"))
  {
    cases.AddSources("tolerance=" + text, arguments.GetInteger("sources"), MeasureMerging, mesh,
      std::atof(text.c_str()));
  }
}
