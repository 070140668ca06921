// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a graph gives: paths, farthest point samples and their Voronoi cells, a matrix of
/// distances; beside exact propagation and the edge paths of VTK, in one run.
///
/// Usage: BenchmarkPath [--benchmark_...] [--name=value...] [mesh...]
///   --accuracy=0.01     of the graph
///   --pairs=1000        random pairs of points anywhere on the surface
///   --targets=10        so many of them have the same start
///   --vertex_pairs=20   random pairs of vertices, for VTK; 0 leaves them out
///   --samples=1000      farthest point samples; 0 leaves them and their cells out
///   --matrix=1000       rows and columns of the matrix; 0 leaves it out
///   --threads=2         threads of the matrix, and of what comes before all that is measured
///   --torus=64          rings of a generated torus; 0 leaves it out
///   --subdivided=armadillo  meshes that are measured after a step of Loop subdivision as well
/// Meshes as for BenchmarkExact. Every mesh is measured in all ways.
///
/// Names of the results are GROUP/MESH/CASE with these groups:
///   Path/MESH/...   PathCases.h; Straight and Default are paths that are straightened, and that
///   try
///                   other detours as well, without landmarks and (MarkedStraight and so on) with
///                   them
///   Cells/MESH/...  CellCases.h
///   Matrix/MESH/Update
/// Times are CPU seconds on one thread, but those of the matrix and of landmarks, which are seconds
/// on the wall. summarize_path.py makes tables of it.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "PathCases.h"

#include <algorithm>
#include <map>

namespace
{
/// Paths that are straightened only, and default ones, which try detours as well.
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
  recipe.Name = "graph"; // the only one
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
