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
/// wall-clock seconds. summarize_path.py makes tables of the result.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "PathCases.h"

#include <algorithm>
#include <map>

namespace
{
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
