// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact geodesic distance from one vertex to all: our two engines, CGAL (when it was found) and
/// the edge graph of VTK, in one run.
///
/// Usage: BenchmarkExact [--benchmark_...] [--growth=FILE|none] [--cgal_limit=N]
///                       [--reference_limit=N] [mesh...]
///
/// Meshes may also come from the environment (DGG_BENCHMARK_MESHES, separated by ':'). Without any,
/// a generated surface is measured, and the bunny of Debian's glmark2-data when it is installed.
/// The growth of engine T is followed over coarser and finer versions (quadric decimation, Loop
/// subdivision; 5K to about 700K vertices) of the mesh of --growth, by default the last mesh.
/// The limits are numbers of vertices above which CGAL (default 60000) and engine R (default
/// 200000) are left out.
///
/// Every line of the result is one source of one mesh, so that peers alternate within a mesh and a
/// busy machine disturbs them alike. Times are CPU seconds of this process, the set-up of each
/// peer's mesh apart ("SetUp" lines). summarize.py makes a table of it.

#include "BenchmarkMesh.h"
#include "ErrorStatistics.h"
#include "MemoryProbe.h"
#include "MeshFile.h"
#include "dggExactGeodesics.h"

#include <benchmark/benchmark.h>
#include <vtkVersion.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <memory>
#include <sstream>

namespace
{
const char* const BunnyFile = "/usr/share/glmark2/models/bunny.obj";

struct Options
{
  std::vector<std::string> Files;
  std::string Growth;
  double CGALLimit = 60000;
  double ReferenceLimit = 200000;
};

/// CPU time of this process in seconds.
double CPUSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// One loop of Google Benchmark: `prepare` is not timed, `run` is.
void Measure(
  benchmark::State& state, const std::function<void()>& prepare, const std::function<void()>& run)
{
  for (auto unused : state)
  {
    (void)unused;
    prepare();
    const double start = CPUSeconds();
    run();
    state.SetIterationTime(CPUSeconds() - start);
  }
}

void ReportMesh(benchmark::State& state, const BenchmarkMesh& mesh)
{
  state.counters["vertices"] = mesh.GetNumberOfVertices();
  state.counters["faces"] = static_cast<double>(mesh.GetArrays().GetNumberOfFaces());
}

void ReportMemory(benchmark::State& state, const BenchmarkMesh& mesh, const MemoryProbe& probe)
{
  const double vertices = mesh.GetNumberOfVertices();
  state.counters["heap_bytes_per_vertex"] = static_cast<double>(probe.GetHeapPeak()) / vertices;
  state.counters["resident_bytes_per_vertex"] =
    static_cast<double>(probe.GetResidentPeak()) / vertices;
}

void ReportErrors(benchmark::State& state, BenchmarkMesh& mesh, dgg::Id source,
  const std::vector<double>& distances)
{
  const auto errors = ErrorStatistics::Of(distances, mesh.GetExactDistances(source));
  state.counters["error_mean"] = errors.Mean;
  state.counters["error_p999"] = errors.Percentile999;
  state.counters["error_max"] = errors.Maximum;
  state.counters["unreached"] = static_cast<double>(errors.Unreached);
}

/// The mesh of a recipe; null, with the state closed, when it cannot be used or is too large.
BenchmarkMesh* Open(benchmark::State& state, const MeshRecipe& recipe, double limit)
{
  BenchmarkMesh& mesh = GetBenchmarkMesh(recipe);
  if (!mesh.GetError().empty())
  {
    state.SkipWithError(mesh.GetError().c_str());
    return nullptr;
  }
  if (mesh.GetNumberOfVertices() > limit)
  {
    state.SkipWithError("above the limit of vertices");
    return nullptr;
  }
  return &mesh;
}

void MeasureSetUp(benchmark::State& state, const MeshRecipe& recipe)
{
  BenchmarkMesh* mesh = Open(state, recipe, dgg::Infinity);
  if (!mesh)
  {
    return;
  }
  const MeshArrays& arrays = mesh->GetArrays();
  const auto build = [&](dgg::SurfaceMesh& surface) {
    dgg::SurfaceMesh::FromPoints(arrays.Points.data(),
      static_cast<dgg::Offset>(arrays.GetNumberOfVertices()), arrays.Triangles.data(),
      static_cast<dgg::Offset>(arrays.GetNumberOfFaces()), surface);
  };
  dgg::SurfaceMesh surface;
  Measure(
    state, [&] { surface = dgg::SurfaceMesh(); }, [&] { build(surface); });
  ReportMesh(state, *mesh);
  state.counters["mesh_bytes_per_vertex"] =
    static_cast<double>(surface.GetMemorySize()) / mesh->GetNumberOfVertices();
  surface = dgg::SurfaceMesh();
  const MemoryProbe probe;
  build(surface);
  ReportMemory(state, *mesh, probe);
}

void MeasureEngine(benchmark::State& state, const MeshRecipe& recipe, dgg::ExactEngine engine,
  int sourceIndex, double limit)
{
  BenchmarkMesh* mesh = Open(state, recipe, limit);
  if (!mesh)
  {
    return;
  }
  const dgg::Id source = mesh->GetSource(sourceIndex);
  const std::vector<dgg::GeodesicSource> sources = { { dgg::SurfacePoint::AtVertex(source), 0.0 } };
  dgg::ExactOptions options;
  options.Engine = engine;
  dgg::ExactResult result;
  std::unique_ptr<dgg::ExactGeodesics> solver;
  // A new solver for every run: nothing is warm that a user would find cold.
  Measure(
    state,
    [&] {
      solver = std::make_unique<dgg::ExactGeodesics>(mesh->GetSurface());
      result = dgg::ExactResult();
    },
    [&] { solver->Run(sources, options, result); });
  ReportMesh(state, *mesh);
  if (engine == dgg::ExactEngine::Reference)
  {
    ReportErrors(state, *mesh, source, result.Distances);
  }
  state.counters["windows"] = static_cast<double>(result.NumberOfWindows);
  state.counters["windows_per_second"] = benchmark::Counter(
    static_cast<double>(result.NumberOfWindows) * static_cast<double>(state.iterations()),
    benchmark::Counter::kIsRate);
  state.counters["engine_bytes_per_vertex"] =
    static_cast<double>(result.PeakMemory) / mesh->GetNumberOfVertices();

  if (engine == dgg::ExactEngine::Triangle)
  {
    mesh->SetExactDistances(source, std::move(result.Distances));
  }

  // Memory in a run of its own. One source is enough where runs are long.
  if (sourceIndex == 0 || mesh->GetNumberOfVertices() < 2e5)
  {
    solver.reset();
    result = dgg::ExactResult();
    const MemoryProbe probe;
    dgg::ExactGeodesics(mesh->GetSurface()).Run(sources, options, result);
    ReportMemory(state, *mesh, probe);
  }
}

void MeasureVTK(benchmark::State& state, const MeshRecipe& recipe, int sourceIndex)
{
  BenchmarkMesh* mesh = Open(state, recipe, dgg::Infinity);
  if (!mesh)
  {
    return;
  }
  PeerVTK& peer = mesh->GetPeerVTK();
  const dgg::Id source = mesh->GetSource(sourceIndex);
  Measure(
    state, [] {}, [&] { peer.Run(source); });
  ReportMesh(state, *mesh);
  ReportErrors(state, *mesh, source, peer.GetDistances());
}

#ifdef DGG_WITH_CGAL
void MeasureCGAL(benchmark::State& state, const MeshRecipe& recipe, int sourceIndex, double limit)
{
  BenchmarkMesh* mesh = Open(state, recipe, limit);
  if (!mesh)
  {
    return;
  }
  PeerCGAL& peer = mesh->GetPeerCGAL();
  if (!peer.GetRefusal().empty())
  {
    state.SkipWithError(peer.GetRefusal().c_str());
    return;
  }
  const dgg::Id source = mesh->GetSource(sourceIndex);
  peer.SetSourceVertex(source);
  // Seconds per run: memory is measured in the very run that is timed.
  const MemoryProbe probe;
  std::vector<double> distances;
  Measure(
    state, [&] { peer.SetSourceVertex(source); }, [&] { distances = peer.ComputeDistances(); });
  ReportMemory(state, *mesh, probe);
  ReportMesh(state, *mesh);
  ReportErrors(state, *mesh, source, distances);
  peer.SetSourceVertex(source); // frees the tree of the run
}
#endif

template <class Case>
void Register(const std::string& name, Case run)
{
  benchmark::RegisterBenchmark(name.c_str(), run)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->MinTime(0.1);
}

void RegisterEngine(const std::string& prefix, const MeshRecipe& recipe, dgg::ExactEngine engine,
  int source, double limit)
{
  const char* letter = engine == dgg::ExactEngine::Triangle ? "T" : "R";
  Register(prefix + letter + "/" + std::to_string(source),
    [=](benchmark::State& state) { MeasureEngine(state, recipe, engine, source, limit); });
}

void RegisterComparison(const MeshRecipe& recipe, const Options& options)
{
  const std::string prefix = "Exact/" + recipe.Name + "/";
  Register(prefix + "SetUp", [=](benchmark::State& state) { MeasureSetUp(state, recipe); });
  for (int source = 0; source < BenchmarkMesh::NumberOfSources; ++source)
  {
    RegisterEngine(prefix, recipe, dgg::ExactEngine::Triangle, source, dgg::Infinity);
    RegisterEngine(prefix, recipe, dgg::ExactEngine::Reference, source, options.ReferenceLimit);
    Register(prefix + "VTK/" + std::to_string(source),
      [=](benchmark::State& state) { MeasureVTK(state, recipe, source); });
#ifdef DGG_WITH_CGAL
    const double limit = options.CGALLimit;
    Register(prefix + "CGAL/" + std::to_string(source),
      [=](benchmark::State& state) { MeasureCGAL(state, recipe, source, limit); });
#endif
  }
}

/// 5K, 10K, 20K, the mesh itself, and one and two subdivisions of it.
void RegisterGrowth(const MeshRecipe& base)
{
  std::vector<MeshRecipe> recipes;
  for (const int thousands : { 5, 10, 20 })
  {
    MeshRecipe recipe = base;
    recipe.Name += "-" + std::to_string(thousands) + "K";
    recipe.Vertices = 1000 * thousands;
    recipes.push_back(recipe);
  }
  recipes.push_back(base);
  for (const int steps : { 1, 2 })
  {
    MeshRecipe recipe = base;
    recipe.Name += "-x" + std::to_string(steps == 1 ? 4 : 16);
    recipe.Subdivisions = steps;
    recipes.push_back(recipe);
  }
  for (const MeshRecipe& recipe : recipes)
  {
    for (int source = 0; source < BenchmarkMesh::NumberOfSources; ++source)
    {
      RegisterEngine(
        "Growth/" + recipe.Name + "/", recipe, dgg::ExactEngine::Triangle, source, dgg::Infinity);
    }
  }
}

MeshRecipe FromFile(const std::string& file)
{
  MeshRecipe recipe;
  recipe.Name = StemOf(file);
  recipe.File = file;
  return recipe;
}

MeshRecipe Generated()
{
  MeshRecipe recipe;
  recipe.Name = "bumpy_sphere";
  recipe.Level = 6;
  return recipe;
}

/// What Google Benchmark left on the command line; false on a wrong option.
bool ParseOptions(int argc, char** argv, Options& options)
{
  const auto valueOf = [](const std::string& argument) {
    return argument.substr(argument.find('=') + 1);
  };
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.rfind("--growth=", 0) == 0)
    {
      options.Growth = valueOf(argument);
    }
    else if (argument.rfind("--cgal_limit=", 0) == 0)
    {
      options.CGALLimit = std::atof(valueOf(argument).c_str());
    }
    else if (argument.rfind("--reference_limit=", 0) == 0)
    {
      options.ReferenceLimit = std::atof(valueOf(argument).c_str());
    }
    else if (argument.rfind("-", 0) == 0)
    {
      std::cerr << "unknown option " << argument << "\n";
      return false;
    }
    else
    {
      options.Files.push_back(argument);
    }
  }
  if (options.Files.empty())
  {
    const char* listed = std::getenv("DGG_BENCHMARK_MESHES");
    std::istringstream stream(listed ? listed : "");
    for (std::string file; std::getline(stream, file, ':');)
    {
      options.Files.push_back(file);
    }
  }
  for (const std::string& file : options.Files)
  {
    if (!std::ifstream(file))
    {
      std::cerr << "cannot read " << file << "\n";
      return false;
    }
  }
  return true;
}

void AddContext()
{
  benchmark::AddCustomContext("vtk_version", vtkVersion::GetVTKVersion());
  benchmark::AddCustomContext("compiler", DGG_BENCHMARK_COMPILER);
#ifdef DGG_WITH_CGAL
  benchmark::AddCustomContext("cgal_version", DGG_BENCHMARK_CGAL);
#endif
}
}

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  Options options;
  if (!ParseOptions(argc, argv, options))
  {
    return 1;
  }
  std::vector<MeshRecipe> meshes;
  std::transform(options.Files.begin(), options.Files.end(), std::back_inserter(meshes), FromFile);
  if (meshes.empty())
  {
    meshes.push_back(Generated());
    if (std::ifstream(BunnyFile))
    {
      meshes.push_back(FromFile(BunnyFile));
    }
  }
  for (const MeshRecipe& recipe : meshes)
  {
    RegisterComparison(recipe, options);
  }
  if (options.Growth != "none")
  {
    RegisterGrowth(options.Growth.empty() ? meshes.back() : FromFile(options.Growth));
  }
  AddContext();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
