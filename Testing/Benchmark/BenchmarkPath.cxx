// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Applications of a graph: paths, farthest point samples and their Voronoi cells, and a distance
/// matrix, compared with exact propagation and VTK's edge paths, in one run.
///
/// Usage: BenchmarkPath [--benchmark_...] [--name=value...] [mesh...]
///   --accuracy=0.01     of the graph
///   --pairs=1000        random pairs of points anywhere on the surface
///   --targets=10        number of successive pairs with the same start
///   --vertex_pairs=20   random pairs of vertices, for VTK; 0: none
///   --samples=1000      farthest point samples; 0: neither samples nor cells
///   --matrix=1000       rows and columns of the matrix; 0: no matrix
///   --threads=2         threads of the matrix, and of preparations that are not measured
///   --torus=64          rings of a generated torus; 0: no torus
///   --subdivided=armadillo  meshes that are also measured after a step of Loop subdivision
/// Meshes as for BenchmarkExact. All cases are measured on each mesh.
///
/// Names of the results are GROUP/MESH/CASE with these groups:
///   Path/MESH/...   PathCases.h; Straight paths are straightened only, Default paths also try
///                   detours. MarkedStraight and MarkedDefault use landmarks.
///   Cells/MESH/...  CellCases.h
///   Matrix/MESH/Update
/// Times are CPU seconds on one thread, except for the matrix and landmarks, where they are
/// wall-clock seconds. summarize.py writes tables of the result.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "PeerVTK.h"
#include "Statistics.h"
#include "dggExactGeodesics.h"
#include "dggPathFinder.h"
#include "dggSiteDistances.h"
#include "dggSurfacePath.h"
#include "dggSurfaceSampler.h"
#include "dggVoronoi.h"
#include "vtkGeodesicDistanceMatrix.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace
{
/// Relative difference of lengths up to which a path counts as the shortest one.
constexpr double SameLength = 1e-6;

/// Times of many paths, and their excess: length divided by the exact distance, minus 1.
class PathStatistics
{
public:
  /// Adds a length without a path; both lengths are Infinity if there is no path.
  void AddLength(double seconds, double length, double exact)
  {
    this->Seconds.Add(seconds);
    if (!std::isfinite(length) || !std::isfinite(exact) || exact <= 0.0)
    {
      return;
    }
    const double excess = length / exact - 1.0;
    this->Excess.Add(excess);
    if (excess > SameLength)
    {
      this->Outside.Add(excess);
    }
  }

  void Report(benchmark::State& state) const
  {
    const auto set = [&state](const char* name, double value) { state.counters[name] = value; };
    set("pairs", static_cast<double>(this->Seconds.GetCount()));
    set("ms_median", 1e3 * this->Seconds.GetQuantile(0.5));
    set("ms_p90", 1e3 * this->Seconds.GetQuantile(0.9));
    set("ms_p99", 1e3 * this->Seconds.GetQuantile(0.99));
    set("ms_mean", 1e3 * this->Seconds.GetMean());
    set("within_1e6", this->Excess.GetShareUpTo(1e-6));
    set("within_1e5", this->Excess.GetShareUpTo(1e-5));
    set("within_1e4", this->Excess.GetShareUpTo(1e-4));
    set("excess_median", this->Excess.GetQuantile(0.5));
    set("excess_mean", this->Excess.GetMean());
    set("excess_p99", this->Excess.GetQuantile(0.99));
    set("excess_max", this->Excess.GetMaximum());
    set("outside", static_cast<double>(this->Outside.GetCount()));
    set("outside_median", this->Outside.GetQuantile(0.5));
    set("outside_max", this->Outside.GetMaximum());
  }

private:
  SampleStatistics Seconds;
  SampleStatistics Excess;
  SampleStatistics Outside; // excesses due to another homotopy class, not rounding
};

/// Returns the search of a graph, with or without landmarks.
const dgg::GraphSearch& SearchOf(MeasuredGraph& graph, bool withLandmarks)
{
  if (withLandmarks)
  {
    graph.NeedLandmarks();
  }
  else if (graph.GetSearch().HasLandmarks())
  {
    graph.PrepareSearch();
  }
  return graph.GetSearch();
}

/// Measures landmarks: wall-clock time, and the bytes that the search holds afterwards in addition
/// to those of a query, including the workspaces of all threads that computed the landmarks.
void MeasureLandmarks(benchmark::State& state, const GraphRecipe& recipe, int threads)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  dgg::GraphSearch search(opened.Graph->GetGraph().View(), &opened.Mesh->GetSurface());
  // The preparation of the first query does not belong to the landmarks.
  dgg::SearchResult result;
  dgg::Status status = search.Run({ dgg::GraphSeed{ 0 } }, {}, result);
  const std::size_t before = search.GetMemorySize();
  Measure(
    state, [] {}, [&] { status = search.PrepareLandmarks(ThreadedLoop(threads), nullptr); },
    WallSeconds);
  Require(status);
  state.counters["threads"] = threads;
  state.counters["landmark_bytes"] = static_cast<double>(search.GetMemorySize() - before);
}

/// Measures the function `find`, which returns the length between two points, pair by pair. The
/// time of the case is the mean over the pairs. The first path is not measured.
template <typename Find>
void MeasureLengths(
  benchmark::State& state, BenchmarkMesh& mesh, const PairRecipe& pairs, const Find& find)
{
  MeasuredPairs& measured = mesh.GetPairs(pairs);
  const std::vector<double>& exact = measured.GetExactDistances();
  PathStatistics statistics;
  find(measured.GetStart(0), measured.GetEnd(0), exact[0]);
  for (auto unused : state)
  {
    (void)unused;
    statistics = PathStatistics();
    double sum = 0.0;
    for (std::size_t i = 0; i < measured.GetCount(); ++i)
    {
      const double start = ThreadSeconds();
      const double length = find(measured.GetStart(i), measured.GetEnd(i), exact[i]);
      const double seconds = ThreadSeconds() - start;
      sum += seconds;
      statistics.AddLength(seconds, length, exact[i]);
    }
    state.SetIterationTime(sum / static_cast<double>(measured.GetCount()));
  }
  ReportMesh(state, mesh);
  statistics.Report(state);
}

void MeasurePaths(benchmark::State& state, const GraphRecipe& recipe, const PairRecipe& pairs,
  const dgg::PathOptions& options, bool withLandmarks)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  const dgg::PathFinder finder(opened.Mesh->GetSurface(), SearchOf(*opened.Graph, withLandmarks),
    &opened.Graph->GetBuilder(), opened.Mesh->GetArrays().Points.data());
  dgg::FoundPath found;
  MeasureLengths(state, *opened.Mesh, pairs,
    [&](const dgg::SurfacePoint& from, const dgg::SurfacePoint& to, double) {
      Require(finder.Find(from, to, options, found));
      return found.Path.IsEmpty() ? dgg::Infinity : found.Path.Length;
    });
}

/// Measures VTK's paths along mesh edges between pairs of vertices.
void MeasureEdgePaths(benchmark::State& state, const MeshRecipe& recipe, const PairRecipe& pairs)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  PeerVTK peer(mesh.GetPolyData());
  MeasureLengths(state, mesh, pairs,
    [&](const dgg::SurfacePoint& from, const dgg::SurfacePoint& to, double exact) {
      // The peer cannot handle a missing path.
      return std::isfinite(exact) ? peer.FindPath(from.Vertex, to.Vertex) : dgg::Infinity;
    });
}

/// Number of rounds in which the compared methods are timed alternately. The smallest times are
/// compared, because other load on the machine affects only some of them.
constexpr int Rounds = 3;
constexpr int NumberOfQueries = 10;

double TimeOf(const std::function<void()>& run)
{
  const double start = CPUSeconds();
  run();
  return CPUSeconds() - start;
}

/// Runs queries from single vertices to all; corrections as in MeasureQuery().
void RunQueries(const OpenedGraph& opened, int count, bool correct, dgg::SearchResult& result)
{
  dgg::SearchOptions options;
  options.Correct = correct;
  for (int k = 0; k < count; ++k)
  {
    dgg::GraphSeed seed;
    seed.Vertex = opened.Mesh->GetSource(k, count);
    opened.Graph->GetSearch().Run({ seed }, options, result);
  }
}

dgg::Status Sample(const OpenedGraph& opened, int count, std::vector<dgg::SurfaceSample>& samples)
{
  dgg::SamplerOptions options;
  options.NumberOfSamples = count;
  options.FirstVertex = opened.Mesh->GetSource(0, 1);
  return dgg::SampleSurface(opened.Graph->GetGraph().View(), &opened.Mesh->GetSurface(), nullptr,
    opened.Graph->GetOptions().Accuracy, options, samples);
}

/// Converts samples to sites, with all input of boundary refinement except the builder.
dgg::VoronoiInput ToSites(const std::vector<dgg::SurfaceSample>& samples, double accuracy)
{
  dgg::VoronoiInput sites;
  sites.Accuracy = accuracy;
  for (const dgg::SurfaceSample& sample : samples)
  {
    dgg::GraphSeed seed;
    seed.Vertex = sample.Point.Vertex;
    seed.Source = static_cast<dgg::Id>(sites.Seeds.size());
    sites.Seeds.push_back(seed);
    sites.Places.push_back(sample.Point);
  }
  return sites;
}

/// Measures farthest point samples at vertices, and ten queries from single vertices to all.
void MeasureFarthestPoints(benchmark::State& state, const GraphRecipe& recipe, int samples)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  SampleStatistics queries;
  SampleStatistics sampling;
  std::vector<dgg::SurfaceSample> found;
  dgg::SearchResult result;
  dgg::Status status;
  RunQueries(opened, 1, false, result); // the first query is not measured
  for (auto unused : state)
  {
    (void)unused;
    for (int round = 0; round < Rounds; ++round)
    {
      queries.Add(TimeOf([&] { RunQueries(opened, NumberOfQueries, false, result); }));
      sampling.Add(TimeOf([&] { status = Sample(opened, samples, found); }));
    }
    state.SetIterationTime(sampling.GetMinimum());
  }
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["samples"] = static_cast<double>(found.size());
  state.counters["covering_radius"] = found.back().CoveringRadius;
  state.counters["ten_queries_seconds"] = queries.GetMinimum();
  state.counters["per_ten_queries"] = sampling.GetMinimum() / queries.GetMinimum();
}

/// Measures the Voronoi diagram of these samples, with and without refined boundaries, its vertex
/// labels alone, and a single search from all samples, which yields labels without correction; for
/// comparison also one query.
void MeasureVoronoi(benchmark::State& state, const GraphRecipe& recipe, int samples)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  std::vector<dgg::SurfaceSample> found;
  dgg::Status status = Sample(opened, samples, found);
  Require(status);
  const dgg::VoronoiInput sites = ToSites(found, opened.Graph->GetOptions().Accuracy);
  dgg::VoronoiInput refined = sites;
  refined.Builder = &opened.Graph->GetBuilder();
  const dgg::GraphSearch& search = opened.Graph->GetSearch();
  const dgg::SurfaceMesh& surface = opened.Mesh->GetSurface();
  SampleStatistics query;
  SampleStatistics correctedQuery;
  SampleStatistics nearest;
  SampleStatistics labels;
  SampleStatistics diagrams;
  SampleStatistics refinedDiagrams;
  dgg::SearchResult result;
  dgg::VoronoiDiagram diagram;
  RunQueries(opened, 1, true, result); // the first query is not measured
  for (auto unused : state)
  {
    (void)unused;
    for (int round = 0; round < Rounds; ++round)
    {
      const auto one = [&](bool correct) {
        return TimeOf([&] { RunQueries(opened, NumberOfQueries, correct, result); }) /
          NumberOfQueries;
      };
      query.Add(one(false));
      correctedQuery.Add(one(true));
      nearest.Add(TimeOf([&] { status = search.Run(sites.Seeds, {}, result); }));
      labels.Add(TimeOf([&] {
        dgg::SiteDistances distances;
        status = distances.Run(search, surface, sites.Seeds, nullptr);
      }));
      const auto draw = [&](const dgg::VoronoiInput& input) {
        return TimeOf(
          [&] { status = dgg::ComputeVoronoi(search, surface, input, nullptr, diagram); });
      };
      diagrams.Add(draw(sites));
      refinedDiagrams.Add(draw(refined));
    }
    state.SetIterationTime(refinedDiagrams.GetMinimum());
  }
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["samples"] = static_cast<double>(found.size());
  state.counters["polygons"] = static_cast<double>(diagram.GetNumberOfPolygons());
  state.counters["query_seconds"] = query.GetMinimum();
  state.counters["corrected_query_seconds"] = correctedQuery.GetMinimum();
  state.counters["nearest_per_query"] = nearest.GetMinimum() / query.GetMinimum();
  state.counters["labels_seconds"] = labels.GetMinimum();
  state.counters["labels_per_query"] = labels.GetMinimum() / query.GetMinimum();
  state.counters["labels_per_corrected"] = labels.GetMinimum() / correctedQuery.GetMinimum();
  state.counters["diagram_per_query"] = diagrams.GetMinimum() / query.GetMinimum();
  state.counters["refined_per_query"] = refinedDiagrams.GetMinimum() / query.GetMinimum();
}

constexpr unsigned int RowSeed = 20190523u;
constexpr unsigned int ColumnSeed = 20190524u;

/// Returns surface points as points in space.
vtkSmartPointer<vtkPolyData> ToPolyData(
  const BenchmarkMesh& mesh, const std::vector<dgg::SurfacePoint>& points)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const dgg::SurfacePoint& point : points)
  {
    places->InsertNextPoint(
      dgg::PositionOf(mesh.GetSurface(), point, mesh.GetArrays().Points.data()).data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(places);
  return data;
}

/// Returns the errors of the first row of the matrix.
ErrorStatistics CheckFirstRow(const BenchmarkMesh& mesh, const dgg::SurfacePoint& row,
  const std::vector<dgg::SurfacePoint>& columns, vtkDoubleArray* matrix)
{
  dgg::ExactOptions options;
  options.Targets = columns;
  options.StopAtTargets = true;
  dgg::ExactResult exact;
  dgg::ExactGeodesics(mesh.GetSurface()).Run({ { row, 0.0 } }, options, exact);
  const double* values = matrix->GetPointer(0);
  return { { values, values + columns.size() }, exact.TargetDistances };
}

/// Measures vtkGeodesicDistanceMatrix between two sets of `size` random surface points: wall-clock
/// time of an update with the graph of an earlier update, and the errors of one row. The filter
/// keeps the graph between updates.
void MeasureMatrix(
  benchmark::State& state, const MeshRecipe& recipe, double accuracy, int size, int threads)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  const dgg::SurfaceMesh& surface = mesh.GetSurface();
  const auto rows = RandomPoints(surface, size, false, RowSeed);
  const auto columns = RandomPoints(surface, size, false, ColumnSeed);
  vtkSMPTools::Initialize(threads);
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  filter->SetInputData(mesh.GetPolyData());
  filter->SetAccuracy(accuracy);
  filter->SetUnreachedValue(dgg::Infinity);
  filter->GenerateTableOff();
  // Builds the graph and the structures that link points to it.
  filter->SetRowData(ToPolyData(mesh, { rows[0] }));
  filter->SetColumnData(ToPolyData(mesh, { columns[0] }));
  filter->Update();
  const vtkMTimeType built = filter->GetGraphBuildTime();
  filter->SetRowData(ToPolyData(mesh, rows));
  filter->SetColumnData(ToPolyData(mesh, columns));
  Measure(
    state, [&] { filter->Modified(); }, [&] { filter->Update(); }, WallSeconds);
  vtkSMPTools::Initialize();
  Require(filter->GetMatrix()->GetNumberOfTuples() == size && filter->GetGraphBuildTime() == built,
    "no matrix, or the graph was built again");
  ReportMesh(state, mesh);
  state.counters["size"] = size;
  state.counters["threads"] = threads;
  ReportErrors(state, CheckFirstRow(mesh, rows[0], columns, filter->GetMatrix()));
}

/// Detour options: paths that are straightened only, and default paths, which also try detours.
const std::map<std::string, double> Detours = {
  { "Straight", 0.0 },
  { "Default", dgg::PathOptions().Detour },
};

void RegisterPaths(const GraphRecipe& recipe, const BenchmarkArguments& arguments)
{
  const CaseGroup cases("Path/" + recipe.Mesh.Name + "/", Once);
  PairRecipe pairs;
  pairs.Count = arguments.GetAtLeast("pairs", 1);
  pairs.PerStart = arguments.GetAtLeast("targets", 1);
  for (const bool withLandmarks : { false, true })
  {
    if (withLandmarks)
    {
      cases.Add("Landmarks", MeasureLandmarks, recipe, arguments.GetAtLeast("threads", 1));
    }
    for (const auto& [kind, detour] : Detours)
    {
      dgg::PathOptions options;
      options.Detour = detour;
      const std::string name = (withLandmarks ? "Marked" : "") + kind;
      cases.Add(name, MeasurePaths, recipe, pairs, options, withLandmarks);
    }
  }
  pairs.Count = arguments.GetAtLeast("vertex_pairs", 0);
  pairs.AtVertices = true;
  if (pairs.Count > 0)
  {
    cases.Add("VertexDefault", MeasurePaths, recipe, pairs, dgg::PathOptions(), false);
    cases.Add("VertexVTK", MeasureEdgePaths, recipe.Mesh, pairs);
  }
}

void RegisterMesh(const MeshRecipe& mesh, const BenchmarkArguments& arguments)
{
  GraphRecipe recipe;
  recipe.Mesh = mesh;
  recipe.Name = "graph"; // the only graph
  recipe.Options.Accuracy = arguments.GetNumber("accuracy");
  Require(dgg::GraphBuilder::Check(recipe.Options));
  RegisterPaths(recipe, arguments);
  if (const int samples = arguments.GetAtLeast("samples", 0))
  {
    const CaseGroup cases("Cells/" + mesh.Name + "/", Once);
    cases.Add("FarthestPoints", MeasureFarthestPoints, recipe, samples);
    cases.Add("Voronoi", MeasureVoronoi, recipe, samples);
  }
  if (const int size = arguments.GetAtLeast("matrix", 0))
  {
    CaseGroup("Matrix/" + mesh.Name + "/", Once)
      .Add("Update", MeasureMatrix, mesh, recipe.Options.Accuracy, size,
        arguments.GetAtLeast("threads", 1));
  }
}

/// Returns the meshes of the command line, each followed by its subdivision if requested, and the
/// torus.
std::vector<MeshRecipe> ListMeshes(const BenchmarkArguments& arguments)
{
  const std::vector<std::string> subdivided = arguments.GetList("subdivided");
  std::vector<MeshRecipe> meshes;
  for (const MeshRecipe& mesh : arguments.GetMeshes())
  {
    meshes.push_back(mesh);
    if (std::find(subdivided.begin(), subdivided.end(), mesh.Name) != subdivided.end())
    {
      meshes.push_back(Subdivided(mesh));
    }
  }
  if (arguments.GetInteger("torus") != 0)
  {
    meshes.push_back(TorusOfRings(arguments.GetInteger("torus")));
  }
  return meshes;
}

void RegisterAll(const BenchmarkArguments& arguments)
{
  for (const MeshRecipe& mesh : ListMeshes(arguments))
  {
    RegisterMesh(mesh, arguments);
  }
}
}

int main(int argc, char** argv)
{
  return RunBenchmarks(argc, argv,
    { { "accuracy", "0.01" }, { "pairs", "1000" }, { "targets", "10" }, { "vertex_pairs", "20" },
      { "samples", "1000" }, { "matrix", "1000" }, { "threads", "2" }, { "torus", "64" },
      { "subdivided", "armadillo" } },
    RegisterAll);
}
