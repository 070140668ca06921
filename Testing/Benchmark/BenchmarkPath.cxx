// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a graph gives: paths, farthest point samples and their Voronoi cells, a matrix of
/// distances, closed geodesics; beside exact propagation and the edge paths of VTK, in one run.
///
/// Usage: BenchmarkPath [--benchmark_...] [--name=value...] [mesh...]
///   --accuracy=0.01     of the graph
///   --pairs=1000        random pairs of points anywhere on the surface
///   --targets=10        so many of them have the same start
///   --vertex_pairs=20   random pairs of vertices, for VTK; 0 leaves them out
///   --samples=1000      farthest point samples; 0 leaves them and their cells out
///   --matrix=1000       rows and columns of the matrix; 0 leaves it out
///   --loops=5           vertices that loops are asked to go through; 0 leaves all loops out
///   --threads=2         threads of the matrix, and of what comes before all that is measured
///   --torus=64          rings of a generated torus, for loops as the generated surface has no
///                       handle; 0 leaves it out
///   --subdivided=armadillo  meshes that are measured after a step of Loop subdivision as well
/// Meshes as for BenchmarkExact. Every mesh is measured in all ways.
///
/// Names of the results are GROUP/MESH/CASE with these groups:
///   Path/MESH/...   PathCases.h; Raw, Straight and Default are paths as traced in the graph,
///                   straightened, and with other detours tried as well, without landmarks and
///                   (MarkedRaw and so on) with them
///   Cells/MESH/...  CellCases.h
///   Matrix/MESH/Update
///   Loop/MESH/...   LoopCases.h
/// Times are CPU seconds on one thread, but those of the matrix, of the graph and of landmarks,
/// which are seconds on the wall. summarize_path.py makes tables of it.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "CellCases.h"
#include "LoopCases.h"
#include "MatrixCases.h"
#include "PathCases.h"

#include <algorithm>
#include <iostream>

namespace
{
using State = benchmark::State;

/// One run is all that is timed: cases gather many times of their own.
constexpr double Once = 1e-9;

struct Settings
{
  dgg::GraphOptions Options;
  PairRecipe Pairs;
  PairRecipe VertexPairs;
  int Samples = 0;
  int Matrix = 0;
  int Loops = 0;
  int Threads = 0;
};

struct PathKind
{
  const char* Name;
  bool Straighten;
  bool WithDetours;
};

const std::vector<PathKind> PathKinds = {
  { "Raw", false, false },
  { "Straight", true, false },
  { "Default", true, true },
};

dgg::PathOptions OptionsOf(const PathKind& kind)
{
  dgg::PathOptions options;
  options.Straighten = kind.Straighten;
  if (!kind.WithDetours)
  {
    options.Detour = 0.0;
  }
  return options;
}

void RegisterPaths(const GraphRecipe& recipe, const Settings& settings)
{
  const std::string prefix = "Path/" + recipe.Mesh.Name + "/";
  const PairRecipe pairs = settings.Pairs;
  const int threads = settings.Threads;
  RegisterCase(
    prefix + "Graph", [=](State& state) { MeasureGraphOfPaths(state, recipe, threads); }, Once);
  RegisterCase(
    prefix + "FirstPath", [=](State& state) { MeasureFirstPath(state, recipe, pairs); }, Once);
  RegisterCase(
    prefix + "Exact", [=](State& state) { MeasureExactPairs(state, recipe.Mesh, pairs); }, Once);
  for (const bool isKept : { true, false })
  {
    RegisterCase(
      prefix + (isKept ? "ShortKept" : "ShortAnew"),
      [=](State& state) { MeasureShortPaths(state, recipe.Mesh, isKept); }, Once);
  }
  for (const bool withLandmarks : { false, true })
  {
    if (withLandmarks)
    {
      RegisterCase(
        prefix + "Landmarks", [=](State& state) { MeasureLandmarks(state, recipe, threads); },
        Once);
    }
    for (const PathKind& kind : PathKinds)
    {
      const dgg::PathOptions options = OptionsOf(kind);
      RegisterCase(
        prefix + (withLandmarks ? "Marked" : "") + kind.Name,
        [=](State& state) { MeasurePaths(state, recipe, pairs, options, withLandmarks); }, Once);
    }
  }
  if (settings.VertexPairs.Count > 0)
  {
    const PairRecipe vertexPairs = settings.VertexPairs;
    RegisterCase(
      prefix + "VertexDefault",
      [=](State& state) { MeasurePaths(state, recipe, vertexPairs, {}, false); }, Once);
    RegisterCase(
      prefix + "VertexVTK",
      [=](State& state) { MeasureEdgePaths(state, recipe.Mesh, vertexPairs); }, Once);
  }
}

void RegisterCells(const GraphRecipe& recipe, int samples)
{
  const std::string prefix = "Cells/" + recipe.Mesh.Name + "/";
  RegisterCase(
    prefix + "FarthestPoints", [=](State& state) { MeasureFarthestPoints(state, recipe, samples); },
    Once);
  RegisterCase(
    prefix + "Voronoi", [=](State& state) { MeasureVoronoi(state, recipe, samples); }, Once);
}

void RegisterMatrix(const GraphRecipe& recipe, int size, int threads)
{
  RegisterCase(
    "Matrix/" + recipe.Mesh.Name + "/Update",
    [=](
      State& state) { MeasureMatrix(state, recipe.Mesh, recipe.Options.Accuracy, size, threads); },
    Once);
}

void RegisterLoops(const GraphRecipe& recipe, int points)
{
  const std::string prefix = "Loop/" + recipe.Mesh.Name + "/";
  RegisterCase(
    prefix + "AroundHandles", [=](State& state) { MeasureAroundHandles(state, recipe.Mesh); },
    Once);
  RegisterCase(
    prefix + "ThroughPoint",
    [=](State& state) { MeasureThroughPoint(state, recipe, points, false); }, Once);
  RegisterCase(
    prefix + "ThroughPointTaut",
    [=](State& state) { MeasureThroughPoint(state, recipe, points, true); }, Once);
}

void RegisterMesh(const MeshRecipe& mesh, const Settings& settings)
{
  GraphRecipe recipe;
  recipe.Mesh = mesh;
  recipe.Name = "graph"; // the only one
  recipe.Options = settings.Options;
  RegisterPaths(recipe, settings);
  if (settings.Samples > 0)
  {
    RegisterCells(recipe, settings.Samples);
  }
  if (settings.Loops > 0)
  {
    RegisterLoops(recipe, settings.Loops);
  }
  if (settings.Matrix > 0)
  {
    RegisterMatrix(recipe, settings.Matrix, settings.Threads);
  }
}

/// What was named, the subdivided ones after those that they come from, and the torus.
std::vector<MeshRecipe> ListMeshes(const BenchmarkArguments& arguments)
{
  const std::vector<std::string> subdivided = arguments.GetList("subdivided");
  std::vector<MeshRecipe> meshes;
  for (const MeshRecipe& mesh : arguments.GetMeshes())
  {
    meshes.push_back(mesh);
    if (std::find(subdivided.begin(), subdivided.end(), mesh.Name) != subdivided.end())
    {
      meshes.push_back(mesh);
      meshes.back().Name += "-x4";
      meshes.back().Subdivisions = 1;
    }
  }
  const int rings = static_cast<int>(arguments.GetNumber("torus"));
  if (rings > 0)
  {
    MeshRecipe torus;
    torus.Name = "torus";
    torus.Rings = rings;
    meshes.push_back(torus);
  }
  return meshes;
}

/// False, with a message, when the arguments make no sense.
bool ReadSettings(const BenchmarkArguments& arguments, Settings& settings)
{
  const auto number = [&arguments](
                        const char* name) { return static_cast<int>(arguments.GetNumber(name)); };
  settings.Options.Accuracy = arguments.GetNumber("accuracy");
  settings.Pairs.Count = number("pairs");
  settings.Pairs.PerStart = number("targets");
  settings.VertexPairs.Count = number("vertex_pairs");
  settings.VertexPairs.PerStart = settings.Pairs.PerStart;
  settings.VertexPairs.AtVertices = true;
  settings.Samples = number("samples");
  settings.Matrix = number("matrix");
  settings.Loops = number("loops");
  settings.Threads = number("threads");
  const dgg::Status status = dgg::GraphBuilder::Check(settings.Options);
  if (!status.IsOk())
  {
    std::cerr << status.GetMessage() << "\n";
    return false;
  }
  if (std::min({ settings.Pairs.Count, settings.Pairs.PerStart, settings.Threads }) < 1 ||
    std::min({ settings.VertexPairs.Count, settings.Samples, settings.Matrix, settings.Loops }) < 0)
  {
    std::cerr << "pairs, targets and threads must be at least 1, all else at least 0\n";
    return false;
  }
  const int rings = number("torus");
  if (rings != 0 && rings < 6)
  {
    std::cerr << "a torus has at least 6 rings\n";
    return false;
  }
  return true;
}
}

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  BenchmarkArguments arguments({ { "accuracy", "0.01" }, { "pairs", "1000" }, { "targets", "10" },
    { "vertex_pairs", "20" }, { "samples", "1000" }, { "matrix", "1000" }, { "loops", "5" },
    { "threads", "2" }, { "torus", "64" }, { "subdivided", "armadillo" } });
  Settings settings;
  if (!arguments.Parse(argc, argv) || !ReadSettings(arguments, settings))
  {
    return 1;
  }
  for (const MeshRecipe& mesh : ListMeshes(arguments))
  {
    RegisterMesh(mesh, settings);
  }
  AddBenchmarkContext();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
