// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Rules of the thesis that the module has corrected or replaced, as published, and the methods
/// that the thesis compares with, measured together with ours.
///
/// Usage: BenchmarkPublished [--benchmark_...] [--name=value...] [mesh...]
///   --accuracies=0.01,0.001   of the graphs
///   --sources=3               sources for the errors
///   --rules=OneRelay          graphs for the queues: OneRelay, Guaranteed, Indirect
///   --parts=Queue,Pruning,Pseudo,Heat,Unfolding,Merging
///   --steps=0,10              steps of the variational heat method; 0 is the heat method
///   --vertex=-1               source of this method; -1: as many sources as --sources
///   --fields=                 folder for its distances, as raw doubles
///   --samples=100,400         samples of triangle unfolding
///   --pairs=2000              pairs of vertices for triangle unfolding and the graph
///   --tolerances=0,0.001,0.01 tolerances of merged windows; 0 is the exact engine
/// Meshes as for BenchmarkExact.
///
/// Names of the results are
///   Published/MESH/Queue/RULE/QUEUE/FANS/ACCURACY/K
///       QUEUE is FIFO, SLF, LLL or Both; FANS are All, Narrow (arcsin sqrt(accuracy), as
///       published) or Wide (the largest deviation of two successive edges)
///   Published/MESH/Pruning/RULE/ACCURACY/Build, .../Query/K
///       RULE is None, Progress or Published
///   Published/MESH/Pseudo/RULE/ACCURACY/Build, .../Query/K
///       RULE is Plain (candidates of the unchanged mesh, pruned as published), Pseudo (the same
///       with pseudo-vertices) or Guaranteed
///   Published/MESH/Heat/TRIANGLES/steps=N/K
///       TRIANGLES are Direct or Delaunay
///   Published/MESH/Unfolding/samples=N, .../Graph/ACCURACY, .../Paths/ACCURACY
///       times of the preparation; queries are in a counter
///   Published/MESH/Merging/tolerance=X/K
/// Times are CPU seconds on one thread.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "CandidateGraph.h"
#include "LabelQueue.h"
#include "PseudoVertices.h"
#include "RivalCases.h"
#include "dggGraphFans.h"

#include <cmath>
#include <cstdlib>
#include <map>

namespace
{
using Construction = dgg::GraphConstruction;

const std::map<std::string, Construction> Constructions = {
  { "OneRelay", Construction::OneRelay },
  { "Guaranteed", Construction::Guaranteed },
  { "Indirect", Construction::Indirect },
};
const std::map<std::string, QueueRule> Queues = {
  { "FIFO", QueueRule::FirstInFirstOut },
  { "SLF", QueueRule::SmallLabelFirst },
  { "LLL", QueueRule::LargeLabelLast },
  { "Both", QueueRule::SmallAndLarge },
};
const std::map<std::string, void (*)(const MeshRecipe&, const BenchmarkArguments&)> Rivals = {
  { "Heat", RegisterHeat },
  { "Unfolding", RegisterUnfolding },
  { "Merging", RegisterMerging },
};

double FanTolerance(const std::string& fans, const dgg::GraphView& graph)
{
  if (fans == "All")
  {
    return 0.0;
  }
  return fans == "Narrow" ? std::asin(std::sqrt(graph.Info.Accuracy))
                          : 2.0 * dgg::LargestDeviation(graph);
}

void MeasureQueue(benchmark::State& state, const GraphRecipe& recipe, QueueRule rule,
  const std::string& fans, int k, int numberOfSources)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  const dgg::GraphView graph = opened.Graph->GetGraph().View();
  const dgg::Id source = opened.Mesh->GetSource(k, numberOfSources);
  LabelResult result;
  Measure(
    state, [] {},
    [&] {
      result =
        SearchByLabels(graph, opened.Mesh->GetSurface(), source, rule, FanTolerance(fans, graph));
    });
  const double vertices = opened.Mesh->GetNumberOfVertices();
  double degree = 0.0;
  double deviation = 0.0;
  opened.Graph->GetDegree(degree, deviation);
  state.counters["degree_mean"] = degree;
  state.counters["pops_per_vertex"] = static_cast<double>(result.Pops) / vertices;
  state.counters["relaxations_per_vertex"] = static_cast<double>(result.Relaxations) / vertices;
  state.counters["rotations_per_vertex"] = static_cast<double>(result.Rotations) / vertices;
  ReportMesh(state, *opened.Mesh);
  ReportErrors(state, *opened.Mesh, source, result.Distances);
}

/// A graph that the library does not build. Only the last one is kept.
struct OwnGraph
{
  std::string Name;
  dgg::GeodesicGraph Graph;
  CandidateStatistics Statistics;
  dgg::SurfaceMesh Surface; ///< with pseudo-vertices
  dgg::Id Added = 0;
};

using Builder = std::function<dgg::Status(const dgg::SurfaceMesh&, double, OwnGraph&)>;

OwnGraph& Kept()
{
  static OwnGraph kept;
  return kept;
}

void Build(benchmark::State& state, const MeshRecipe& recipe, const std::string& name,
  const Builder& builder, double accuracy)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  OwnGraph& own = Kept();
  dgg::Status status;
  Measure(
    state, [&] { own = OwnGraph(); }, [&] { status = builder(mesh.GetSurface(), accuracy, own); });
  Require(status);
  own.Name = recipe.Name + "/" + name;
  ReportMesh(state, mesh);
  state.counters["degree_mean"] =
    static_cast<double>(own.Graph.View().GetNumberOfEdges()) / own.Graph.GetNumberOfVertices();
  state.counters["edges"] = static_cast<double>(own.Graph.View().GetNumberOfEdges());
  state.counters["candidates_per_vertex"] = own.Statistics.CandidatesPerVertex;
  state.counters["finding_seconds"] = own.Statistics.FindingSeconds;
  state.counters["pruning_seconds"] = own.Statistics.PruningSeconds;
  state.counters["added_per_vertex"] = own.Added / mesh.GetNumberOfVertices();
}

/// Measures a query from a vertex to all of the mesh in the graph that was built last.
void Query(benchmark::State& state, const MeshRecipe& recipe, const std::string& name, int k,
  int numberOfSources)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  const OwnGraph& own = Kept();
  Require(own.Name == recipe.Name + "/" + name, "the graph was not built");
  const dgg::Id source = mesh.GetSource(k, numberOfSources);
  const dgg::GraphSearch search(own.Graph.View(), nullptr);
  dgg::SearchOptions options;
  options.Method = dgg::SearchMethod::Dijkstra;
  dgg::GraphSeed seed;
  seed.Vertex = source;
  dgg::SearchResult result;
  dgg::Status status;
  Measure(
    state, [] {}, [&] { status = search.Run({ seed }, options, result); });
  Require(status);
  // Pseudo-vertices, which come last, are excluded.
  result.Distances.resize(static_cast<std::size_t>(mesh.GetNumberOfVertices()));
  ReportErrors(state, mesh, source, result.Distances);
}

/// Builds the graph with pseudo-vertices. Gaps are searched in the graph of all candidates.
dgg::Status BuildPseudo(const dgg::SurfaceMesh& surface, double accuracy, OwnGraph& own)
{
  dgg::GeodesicGraph candidates;
  DGG_RETURN_IF_ERROR(
    BuildFromCandidates(surface, accuracy, PruningRule::None, candidates, own.Statistics));
  DGG_RETURN_IF_ERROR(
    AddPseudoVertices(surface, candidates.View(), accuracy, own.Surface, own.Added));
  return BuildFromCandidates(
    own.Surface, accuracy, PruningRule::Published, own.Graph, own.Statistics);
}

Builder FromCandidates(PruningRule rule)
{
  return [rule](const dgg::SurfaceMesh& surface, double accuracy, OwnGraph& own) {
    return BuildFromCandidates(surface, accuracy, rule, own.Graph, own.Statistics);
  };
}

dgg::Status BuildGuaranteed(const dgg::SurfaceMesh& surface, double accuracy, OwnGraph& own)
{
  dgg::GraphOptions options;
  options.Accuracy = accuracy;
  return dgg::GraphBuilder(surface).Build(options, own.Graph);
}

/// Functions that build the graphs, by part and rule.
const std::map<std::string, std::map<std::string, Builder>> Builders = {
  { "Pruning",
    { { "None", FromCandidates(PruningRule::None) },
      { "Progress", FromCandidates(PruningRule::Progress) },
      { "Published", FromCandidates(PruningRule::Published) } } },
  { "Pseudo",
    { { "Plain", FromCandidates(PruningRule::Published) }, { "Guaranteed", BuildGuaranteed },
      { "Pseudo", BuildPseudo } } },
};

void RegisterMesh(const MeshRecipe& mesh, const std::string& part, const std::string& text,
  const BenchmarkArguments& arguments)
{
  const double accuracy = std::atof(text.c_str());
  const int sources = arguments.GetInteger("sources");
  const auto builders = Builders.find(part);
  if (builders != Builders.end())
  {
    for (const auto& [rule, builder] : builders->second)
    {
      const std::string name = part + "/" + rule + "/" + text;
      const CaseGroup cases("Published/" + mesh.Name + "/" + name + "/", Once);
      cases.Add("Build", Build, mesh, name, builder, accuracy);
      cases.AddSources("Query", sources, Query, mesh, name);
    }
    return;
  }
  Require(part == "Queue", "there is no part " + part);
  for (const std::string& rule : arguments.GetList("rules"))
  {
    const auto construction = Constructions.find(rule);
    Require(construction != Constructions.end(), "there is no rule " + rule);
    GraphRecipe recipe;
    recipe.Mesh = mesh;
    recipe.Name = rule + "/" + text;
    recipe.Options.Construction = construction->second;
    recipe.Options.Accuracy = accuracy;
    for (const auto& queue : Queues)
    {
      for (const std::string fans : { "All", "Narrow", "Wide" })
      {
        const CaseGroup cases(
          "Published/" + mesh.Name + "/Queue/" + rule + "/" + queue.first + "/" + fans + "/", Once);
        cases.AddSources(text, sources, MeasureQueue, recipe, queue.second, fans);
      }
    }
  }
}

void RegisterAll(const BenchmarkArguments& arguments)
{
  arguments.GetAtLeast("sources", 1);
  for (const std::string& text : arguments.GetList("accuracies"))
  {
    // The library has a lower limit, the graphs of candidates have none.
    Require(std::atof(text.c_str()) > 0.0, "accuracies must be positive");
  }
  for (const MeshRecipe& mesh : arguments.GetMeshes())
  {
    for (const std::string& part : arguments.GetList("parts"))
    {
      const auto rival = Rivals.find(part);
      if (rival != Rivals.end())
      {
        rival->second(mesh, arguments);
        continue;
      }
      for (const std::string& text : arguments.GetList("accuracies"))
      {
        RegisterMesh(mesh, part, text, arguments);
      }
    }
  }
}
}

int main(int argc, char** argv)
{
  return RunBenchmarks(argc, argv,
    { { "accuracies", "0.01,0.001" }, { "sources", "3" }, { "rules", "OneRelay" },
      { "parts", "Queue,Pruning,Pseudo,Heat,Unfolding,Merging" }, { "steps", "0,10" },
      { "vertex", "-1" }, { "fields", "" }, { "samples", "100,400" }, { "pairs", "2000" },
      { "tolerances", "0,0.001,0.01" } },
    RegisterAll);
}
