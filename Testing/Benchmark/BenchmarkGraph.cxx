// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Discrete geodesic graphs: building and asking them, beside the heat method of CGAL (when it was
/// found with Eigen) and the edge graph of VTK, in one run.
///
/// Usage: BenchmarkGraph [--benchmark_...] [--name=value...] [mesh...]
///   --rules=Guaranteed,OneRelay,Indirect,SVG  which constructions
///   --thorough=Guaranteed  of which to measure all: threads, memory, every search, blocks; of the
///                     others only building and the certified search, with and without correction
///   --accuracies=0.1,0.05,0.02,0.01,0.001     of the first three
///   --neighbors=15,30,60                  of the saddle vertex graph (SVG)
///   --sources=10      sources per graph, each a query with each search
///   --many=1000       sources of a run in blocks; 0 leaves it out
///   --threads=2       threads of the parallel cases; 1 leaves them out
/// Meshes as for BenchmarkExact.
///
/// Names of the results are GROUP/MESH/CASE with these groups:
///   Graph/MESH/RULE/PARAMETER/...  one graph (GraphCases.h)
///   Peer/MESH/...                  the others, on the same mesh from the same sources
/// Times are CPU seconds of this process, but those of several threads, which are seconds on the
/// wall. Errors are against our exact engine T. summarize_graph.py makes tables of it.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "ExactCases.h"
#include "GraphCases.h"
#ifdef DGG_WITH_HEAT
#include "HeatCases.h"
#endif

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace
{
struct PlannedGraph
{
  GraphRecipe Recipe; ///< without a mesh
  bool Thorough = false;
};

struct Settings
{
  std::vector<PlannedGraph> Graphs;
  int NumberOfSources = 0;
  int Many = 0;
  int Threads = 0;
};

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

void RegisterQueries(const std::string& prefix, const GraphRecipe& recipe, int sources,
  const std::vector<Search>& searches)
{
  for (int k = 0; k < sources; ++k)
  {
    for (const Search& search : searches)
    {
      RegisterCase(prefix + search.Name + "/" + std::to_string(k), [=](benchmark::State& state) {
        MeasureQuery(state, recipe, search.Method, search.Correct, k, sources);
      });
    }
  }
}

/// What needs more builds, or many queries.
void RegisterThoroughCases(
  const std::string& prefix, const GraphRecipe& recipe, const Settings& settings)
{
  using State = benchmark::State;
  const int threads = settings.Threads;
  const int many = settings.Many;
  // Once: memory that an earlier build has left behind is not seen.
  RegisterCase(
    prefix + "Memory", [=](State& state) { MeasureMemory(state, recipe); }, 1e-9);
  if (threads > 1)
  {
    RegisterCase(
      prefix + "ParallelBuild", [=](State& state) { MeasureParallelBuild(state, recipe, threads); },
      1.0);
  }
  RegisterCase(prefix + "Estimate", [=](State& state) { MeasureEstimate(state, recipe); });
  RegisterQueries(prefix, recipe, settings.NumberOfSources, OtherSearches);
  if (many > 0)
  {
    RegisterCase(prefix + "Many", [=](State& state) { MeasureMany(state, recipe, many, 1); });
  }
  if (many > 0 && threads > 1)
  {
    RegisterCase(
      prefix + "ParallelMany", [=](State& state) { MeasureMany(state, recipe, many, threads); });
  }
}

void RegisterGraph(const GraphRecipe& recipe, bool thorough, const Settings& settings)
{
  using State = benchmark::State;
  const std::string prefix = "Graph/" + recipe.Mesh.Name + "/" + recipe.Name + "/";
  RegisterCase(
    prefix + "Build", [=](State& state) { MeasureBuild(state, recipe); }, 1.0);
  RegisterCase(prefix + "Cache", [=](State& state) { MeasureCache(state, recipe); });
  RegisterCase(prefix + "FirstQuery", [=](State& state) { MeasureFirstQuery(state, recipe); });
  RegisterQueries(prefix, recipe, settings.NumberOfSources, MainSearches);
  if (thorough)
  {
    RegisterThoroughCases(prefix, recipe, settings);
  }
}

#ifdef DGG_WITH_HEAT
void RegisterHeat(const std::string& prefix, const MeshRecipe& recipe,
  PeerHeat::Triangulation triangulation, int sources)
{
  using State = benchmark::State;
  RegisterCase(prefix + "Precompute",
    [=](State& state) { MeasureHeatPrecomputation(state, recipe, triangulation); });
  for (int k = 0; k < sources; ++k)
  {
    RegisterCase(prefix + "Query/" + std::to_string(k),
      [=](State& state) { MeasureHeatQuery(state, recipe, triangulation, k, sources); });
  }
}
#endif

void RegisterPeers(const MeshRecipe& recipe, int sources)
{
  using State = benchmark::State;
  const std::string prefix = "Peer/" + recipe.Name + "/";
  RegisterCase(prefix + "SetUp", [=](State& state) { MeasureSetUp(state, recipe); });
  for (int k = 0; k < sources; ++k)
  {
    RegisterCase(prefix + "Exact/Query/" + std::to_string(k),
      [=](State& state) { MeasureEngine(state, recipe, dgg::ExactEngine::Triangle, k, sources); });
  }
  for (int k = 0; k < sources; ++k)
  {
    RegisterCase(prefix + "VTK/Query/" + std::to_string(k),
      [=](State& state) { MeasureVTK(state, recipe, k, sources); });
  }
#ifdef DGG_WITH_HEAT
  RegisterHeat(prefix + "HeatDirect/", recipe, PeerHeat::Triangulation::Direct, sources);
  RegisterHeat(
    prefix + "HeatDelaunay/", recipe, PeerHeat::Triangulation::IntrinsicDelaunay, sources);
#endif
}

bool Contains(const std::vector<std::string>& list, const std::string& word)
{
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// The graphs of one rule; false when there is no such rule.
bool AddGraphs(
  const std::string& rule, const BenchmarkArguments& arguments, std::vector<PlannedGraph>& graphs)
{
  PlannedGraph graph;
  GraphRecipe& recipe = graph.Recipe;
  graph.Thorough = Contains(arguments.GetList("thorough"), rule);
  if (rule == "SVG")
  {
    recipe.Options.Construction = dgg::GraphConstruction::SaddleVertexGraph;
    for (const std::string& neighbors : arguments.GetList("neighbors"))
    {
      recipe.Name = rule + "/" + neighbors;
      recipe.Options.NumberOfNeighbors = std::atoi(neighbors.c_str());
      graphs.push_back(graph);
    }
    return true;
  }
  if (rule == "OneRelay")
  {
    recipe.Options.Construction = dgg::GraphConstruction::OneRelay;
  }
  else if (rule == "Indirect")
  {
    recipe.Options.Construction = dgg::GraphConstruction::Indirect;
  }
  else if (rule != "Guaranteed")
  {
    return false;
  }
  for (const std::string& accuracy : arguments.GetList("accuracies"))
  {
    recipe.Name = rule + "/" + accuracy;
    recipe.Options.Accuracy = std::atof(accuracy.c_str());
    graphs.push_back(graph);
  }
  return true;
}

/// False, with a message, when the arguments make no sense.
bool ReadSettings(const BenchmarkArguments& arguments, Settings& settings)
{
  for (const std::string& rule : arguments.GetList("rules"))
  {
    if (!AddGraphs(rule, arguments, settings.Graphs))
    {
      std::cerr << "there is no rule " << rule << "\n";
      return false;
    }
  }
  for (const PlannedGraph& graph : settings.Graphs)
  {
    const dgg::Status status = dgg::GraphBuilder::Check(graph.Recipe.Options);
    if (!status.IsOk())
    {
      std::cerr << graph.Recipe.Name << ": " << status.GetMessage() << "\n";
      return false;
    }
  }
  settings.NumberOfSources = static_cast<int>(arguments.GetNumber("sources"));
  settings.Many = static_cast<int>(arguments.GetNumber("many"));
  settings.Threads = static_cast<int>(arguments.GetNumber("threads"));
  if (settings.NumberOfSources < 1 || settings.Many < 0 || settings.Threads < 1)
  {
    std::cerr << "sources and threads must be at least 1, many at least 0\n";
    return false;
  }
  return true;
}
}

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  BenchmarkArguments arguments({ { "rules", "Guaranteed,OneRelay,Indirect,SVG" },
    { "thorough", "Guaranteed" }, { "accuracies", "0.1,0.05,0.02,0.01,0.001" },
    { "neighbors", "15,30,60" }, { "sources", "10" }, { "many", "1000" }, { "threads", "2" } });
  Settings settings;
  if (!arguments.Parse(argc, argv) || !ReadSettings(arguments, settings))
  {
    return 1;
  }
  for (const MeshRecipe& mesh : arguments.GetMeshes())
  {
    RegisterPeers(mesh, settings.NumberOfSources);
    for (PlannedGraph graph : settings.Graphs)
    {
      graph.Recipe.Mesh = mesh;
      RegisterGraph(graph.Recipe, graph.Thorough, settings);
    }
  }
  AddBenchmarkContext();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
