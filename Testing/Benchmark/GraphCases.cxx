// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GraphCases.h"

#include "BenchmarkTools.h"

#include <algorithm>
#include <vector>

namespace
{
double NumberOfEdges(const dgg::GeodesicGraph& graph)
{
  return static_cast<double>(graph.View().GetNumberOfEdges());
}

void ReportGraph(benchmark::State& state, const BenchmarkMesh& mesh, const MeasuredGraph& graph)
{
  const double edges = NumberOfEdges(graph.GetGraph());
  const dgg::GraphStatistics& statistics = graph.GetStatistics();
  double mean = 0.0;
  double deviation = 0.0;
  graph.GetDegree(mean, deviation);
  ReportMesh(state, mesh);
  state.counters["edges"] = edges;
  state.counters["degree_mean"] = mean;
  state.counters["degree_deviation"] = deviation;
  state.counters["windows_per_vertex"] =
    static_cast<double>(statistics.Windows) / mesh.GetNumberOfVertices();
  state.counters["bytes_per_edge"] = static_cast<double>(graph.GetGraph().GetMemorySize()) / edges;
}

dgg::SearchOptions QueryOptions(dgg::SearchMethod method, bool correct)
{
  dgg::SearchOptions options;
  options.Method = method;
  options.Correct = correct;
  return options;
}
}

void MeasureBuild(benchmark::State& state, const GraphRecipe& recipe)
{
  const OpenedGraph opened = OpenGraph(recipe);
  MeasuredGraph& graph = *opened.Graph;
  Measure(
    state, [&] { graph.Clear(); }, [&] { graph.Build({}); });
  Require(graph.GetError());
  ReportGraph(state, *opened.Mesh, graph);
}

void MeasureMemory(benchmark::State& state, const GraphRecipe& recipe)
{
  const OpenedGraph opened = OpenGraph(recipe);
  MeasuredGraph& graph = *opened.Graph;
  graph.Clear();
  const MemoryProbe probe;
  Measure(
    state, [&] { graph.Clear(); }, [&] { graph.Build({}); });
  Require(graph.GetError());
  const double edges = NumberOfEdges(graph.GetGraph());
  state.counters["peak_bytes_per_edge"] = static_cast<double>(probe.GetHeapPeak()) / edges;
  state.counters["resident_bytes_per_edge"] = static_cast<double>(probe.GetResidentPeak()) / edges;
}

void MeasureParallelBuild(benchmark::State& state, const GraphRecipe& recipe, int threads)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  MeasuredGraph other(opened.Mesh->GetSurface(), recipe.Options);
  Measure(
    state, [&] { other.Clear(); }, [&] { other.Build(ThreadedLoop(threads)); }, WallSeconds);
  state.counters["threads"] = threads;
  state.counters["same_bits"] = dgg::ComputeChecksum(other.GetGraph().View()) ==
    dgg::ComputeChecksum(opened.Graph->GetGraph().View());
}

void MeasureEstimate(benchmark::State& state, const GraphRecipe& recipe)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  dgg::GraphEstimate estimate;
  Measure(
    state, [] {},
    [&] { dgg::GraphBuilder(opened.Mesh->GetSurface()).Estimate(recipe.Options, estimate); });
  state.counters["edges_ratio"] = estimate.Edges / NumberOfEdges(opened.Graph->GetGraph());
  MeasuredGraph other(opened.Mesh->GetSurface(), recipe.Options);
  const MemoryProbe probe;
  other.Build({});
  state.counters["peak_ratio"] = estimate.Peak / static_cast<double>(probe.GetHeapPeak());
}

void MeasureCache(benchmark::State& state, const GraphRecipe& recipe)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  Measure(
    state, [] {}, [&] { opened.Graph->PrepareSearch(); });
  state.counters["cache_bytes_per_edge"] =
    static_cast<double>(opened.Graph->GetSearch().GetMemorySize()) /
    NumberOfEdges(opened.Graph->GetGraph());
}

void MeasureFirstQuery(benchmark::State& state, const GraphRecipe& recipe)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  dgg::GraphSeed seed;
  seed.Vertex = opened.Mesh->GetSource(0, 1);
  const dgg::SearchOptions options = QueryOptions(dgg::SearchMethod::Certified, true);
  Measure(
    state, [] {},
    [&] {
      dgg::SearchResult result;
      opened.Graph->PrepareSearch();
      opened.Graph->GetSearch().Run({ seed }, options, result);
    });
}

void MeasureQuery(benchmark::State& state, const GraphRecipe& recipe, dgg::SearchMethod method,
  bool correct, int k, int numberOfSources)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  dgg::GraphSeed seed;
  seed.Vertex = opened.Mesh->GetSource(k, numberOfSources);
  const dgg::SearchOptions options = QueryOptions(method, correct);
  const dgg::GraphSearch& search = opened.Graph->GetSearch();
  dgg::SearchResult result;
  dgg::Status status = search.Run({ seed }, options, result); // the first query is not measured
  Measure(
    state, [] {}, [&] { status = search.Run({ seed }, options, result); });
  Require(status);
  const double vertices = opened.Mesh->GetNumberOfVertices();
  state.counters["pops_per_vertex"] = static_cast<double>(result.NumberOfPops) / vertices;
  state.counters["relaxations_per_vertex"] =
    static_cast<double>(result.NumberOfRelaxations) / vertices;
  ReportErrors(state, *opened.Mesh, seed.Vertex, correct ? result.Corrected : result.Distances);
}

void MeasureMany(
  benchmark::State& state, const GraphRecipe& recipe, int numberOfSources, int threads)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  std::vector<std::vector<dgg::GraphSeed>> sources;
  for (int k = 0; k < numberOfSources; ++k)
  {
    dgg::GraphSeed seed;
    seed.Vertex = opened.Mesh->GetSource(k, numberOfSources);
    sources.push_back({ seed });
  }
  const dgg::GraphSearch& search = opened.Graph->GetSearch();
  const dgg::ParallelFor parallel = threads > 1 ? ThreadedLoop(threads) : dgg::ParallelFor();
  std::vector<double> samples(sources.size());
  dgg::Status status;
  Measure(
    state, [] {},
    [&] {
      status = search.Many(sources, dgg::ManyOptions(), parallel, nullptr,
        [&](std::size_t source, const double* distances, const std::vector<dgg::Id>&) {
          samples[source] = distances[0];
        });
    },
    threads > 1 ? WallSeconds : CPUSeconds);
  Require(status);
  state.counters["sources"] = numberOfSources;
  state.counters["threads"] = threads;
}
