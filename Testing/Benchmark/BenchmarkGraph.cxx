// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Discrete geodesic graphs: construction and queries, compared with our other methods, the heat
/// method of CGAL (if found with Eigen) and the edge graph of VTK, in one run.
///
/// Usage: BenchmarkGraph [--benchmark_...] [--name=value...] [mesh...]
///   --rules=Guaranteed,OneRelay,Indirect,SVG  constructions
///   --thorough=Guaranteed  constructions with all measurements: threads, memory, all searches,
///                     blocks; others: only build and certified search, with and without correction
///   --accuracies=0.1,0.05,0.02,0.01,0.001     of the first three constructions
///   --neighbors=15,30,60                  of the saddle vertex graph (SVG)
///   --sources=10      sources per graph; each is queried with each search
///   --many=1000       sources of a run in blocks; 0: no such run
///   --threads=2       threads of the parallel cases; 1: no parallel cases
/// Meshes as for BenchmarkExact.
///
/// Names of the results are GROUP/MESH/CASE with these groups:
///   Graph/MESH/RULE/PARAMETER/...  one graph
///   Peer/MESH/METHOD/...           other methods on the same mesh from the same sources
/// Times are CPU seconds of this process, except with several threads, where they are wall-clock
/// seconds. Errors are relative to our exact engine T. summarize.py writes tables of the result.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "FieldMethods.h"

#include <algorithm>
#include <cstdlib>
#include <map>
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

/// Measures the CPU time of a build on one thread; reports size, degree, windows and memory.
void MeasureBuild(benchmark::State& state, const GraphRecipe& recipe)
{
  const OpenedGraph opened = OpenGraph(recipe);
  MeasuredGraph& graph = *opened.Graph;
  Measure(
    state, [&] { graph.Clear(); }, [&] { graph.Build({}); });
  Require(graph.GetError());
  ReportGraph(state, *opened.Mesh, graph);
}

/// Measures the peak memory of a build as the system reports it, including tables and workspaces.
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

/// Measures the wall-clock time with several threads; reports if the graph is the same bit by bit.
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

/// Measures the prediction of size and memory; reports predicted and actual values.
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

/// Measures the preparation of the search before the first query (fans, vertex order).
void MeasureCache(benchmark::State& state, const GraphRecipe& recipe)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  Measure(
    state, [] {}, [&] { opened.Graph->PrepareSearch(); });
  state.counters["cache_bytes_per_edge"] =
    static_cast<double>(opened.Graph->GetSearch().GetMemorySize()) /
    NumberOfEdges(opened.Graph->GetGraph());
}

/// Measures this preparation and the first query, with correction.
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

/// Measures a query from the k-th of `numberOfSources` sources to all.
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

/// Measures queries from many sources to all, in blocks.
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

struct Search
{
  const char* Name;
  dgg::SearchMethod Method;
  bool Correct;
};

const std::vector<Search> MainSearches = {
  { "Certified", dgg::SearchMethod::Certified, false },
  { "Corrected", dgg::SearchMethod::Certified, true },
};
const std::vector<Search> OtherSearches = {
  { "LabelCorrecting", dgg::SearchMethod::LabelCorrecting, false },
  { "Dijkstra", dgg::SearchMethod::Dijkstra, false },
};

void RegisterQueries(const CaseGroup& cases, const GraphRecipe& recipe, int sources,
  const std::vector<Search>& searches)
{
  for (int k = 0; k < sources; ++k)
  {
    for (const Search& search : searches)
    {
      cases.AddSource(search.Name, k, sources, MeasureQuery, recipe, search.Method, search.Correct);
    }
  }
}

/// Registers cases that need further builds or many queries.
void RegisterThoroughCases(const CaseGroup& cases, const GraphRecipe& recipe,
  const BenchmarkArguments& arguments, int sources)
{
  const int threads = arguments.GetAtLeast("threads", 1);
  const int many = arguments.GetAtLeast("many", 0);
  // Runs once: later runs would reuse memory that an earlier build has released.
  cases.For(Once).Add("Memory", MeasureMemory, recipe);
  if (threads > 1)
  {
    cases.For(1.0).Add("ParallelBuild", MeasureParallelBuild, recipe, threads);
  }
  cases.Add("Estimate", MeasureEstimate, recipe);
  RegisterQueries(cases, recipe, sources, OtherSearches);
  if (many > 0)
  {
    cases.Add("Many", MeasureMany, recipe, many, 1);
  }
  if (many > 0 && threads > 1)
  {
    cases.Add("ParallelMany", MeasureMany, recipe, many, threads);
  }
}

void RegisterGraph(
  const GraphRecipe& recipe, bool thorough, const BenchmarkArguments& arguments, int sources)
{
  const CaseGroup cases("Graph/" + recipe.Mesh.Name + "/" + recipe.Name + "/");
  cases.For(1.0).Add("Build", MeasureBuild, recipe);
  cases.Add("Cache", MeasureCache, recipe);
  cases.Add("FirstQuery", MeasureFirstQuery, recipe);
  RegisterQueries(cases, recipe, sources, MainSearches);
  if (thorough)
  {
    RegisterThoroughCases(cases, recipe, arguments, sources);
  }
}

void RegisterPeers(const MeshRecipe& recipe, int sources)
{
  const CaseGroup cases("Peer/" + recipe.Name + "/");
  cases.Add("SetUp", MeasureSetUp, recipe);
  cases.AddSources("Exact/Query", sources, MeasureEngine, recipe);
  std::vector<NamedMethod> methods = { EdgesOfVTK(), HeatOfOurs(), MarchingOfOurs() };
#ifdef DGG_WITH_HEAT
  methods.push_back(HeatOfCGAL(PeerHeat::Triangulation::Direct));
  methods.push_back(HeatOfCGAL(PeerHeat::Triangulation::IntrinsicDelaunay));
#endif
  for (const NamedMethod& method : methods)
  {
    if (method.IsPrepared)
    {
      cases.Add(method.Name + "/Precompute", MeasurePreparation, recipe, method);
    }
    cases.AddSources(method.Name + "/Query", sources, MeasureField, recipe, method, dgg::Infinity);
  }
}

bool Contains(const std::vector<std::string>& list, const std::string& word)
{
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// Registers the graphs of one rule of construction.
void RegisterRule(
  const MeshRecipe& mesh, const std::string& rule, const BenchmarkArguments& arguments, int sources)
{
  using Construction = dgg::GraphConstruction;
  static const std::map<std::string, Construction> rules = {
    { "Guaranteed", Construction::Guaranteed }, { "OneRelay", Construction::OneRelay },
    { "Indirect", Construction::Indirect }, { "SVG", Construction::SaddleVertexGraph }
  };
  const auto found = rules.find(rule);
  Require(found != rules.end(), "there is no rule " + rule);
  GraphRecipe recipe;
  recipe.Mesh = mesh;
  recipe.Options.Construction = found->second;
  const bool isCounted = rule == "SVG";
  for (const std::string& value : arguments.GetList(isCounted ? "neighbors" : "accuracies"))
  {
    recipe.Name = rule + "/" + value;
    if (isCounted)
    {
      recipe.Options.NumberOfNeighbors = std::atoi(value.c_str());
    }
    else
    {
      recipe.Options.Accuracy = std::atof(value.c_str());
    }
    const dgg::Status status = dgg::GraphBuilder::Check(recipe.Options);
    Require(status.IsOk(), recipe.Name + ": " + status.GetMessage());
    RegisterGraph(recipe, Contains(arguments.GetList("thorough"), rule), arguments, sources);
  }
}

void RegisterAll(const BenchmarkArguments& arguments)
{
  const int sources = arguments.GetAtLeast("sources", 1);
  for (const MeshRecipe& mesh : arguments.GetMeshes())
  {
    RegisterPeers(mesh, sources);
    for (const std::string& rule : arguments.GetList("rules"))
    {
      RegisterRule(mesh, rule, arguments, sources);
    }
  }
}
}

int main(int argc, char** argv)
{
  return RunBenchmarks(argc, argv,
    { { "rules", "Guaranteed,OneRelay,Indirect,SVG" }, { "thorough", "Guaranteed" },
      { "accuracies", "0.1,0.05,0.02,0.01,0.001" }, { "neighbors", "15,30,60" },
      { "sources", "10" }, { "many", "1000" }, { "threads", "2" } },
    RegisterAll);
}
