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
#include "MergingEngine.h"
#include "PseudoVertices.h"
#include "TriangleUnfolding.h"
#include "VariationalHeat.h"
#include "dggGraphFans.h"
#include "dggHeatMethod.h"
#include "dggPathFinder.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>

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
  ask(measured.GetStart(0),
    measured.GetEnd(0)); // the first query prepares data
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
  ReportErrors(state, ErrorStatistics(lengths, exact));
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

/// Registers the heat method and its variational form.
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

/// Registers pairs of vertices: unfolding of geodesic triangles, and the graph.
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

/// Registers propagation with merged windows.
void RegisterMerging(const MeshRecipe& mesh, const BenchmarkArguments& arguments)
{
  const CaseGroup cases("Published/" + mesh.Name + "/Merging/", Once);
  for (const std::string& text : arguments.GetList("tolerances"))
  {
    cases.AddSources("tolerance=" + text, arguments.GetInteger("sources"), MeasureMerging, mesh,
      std::atof(text.c_str()));
  }
}

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

/// Builds the graph with pseudo-vertices. Gaps are sought in the graph of all candidates.
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
