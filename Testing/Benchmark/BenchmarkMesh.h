// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Mesh of a benchmark, in the form that each peer needs, with exact results.
#ifndef BenchmarkMesh_h
#define BenchmarkMesh_h

#include "MeasuredGraph.h" // for MeasuredGraph
#include "MeasuredPairs.h" // for MeasuredPairs
#include "MeshArrays.h"    // for MeshArrays

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vtkSmartPointer.h> // for the poly data

#include <map>    // for the exact answers
#include <memory> // for the peers
#include <string> // for names
#include <vector> // for distances

class vtkPolyData;

/// Recipe of a mesh: a file or a generator, then decimation or subdivision.
struct MeshRecipe
{
  std::string Name;
  std::string File;     ///< file name; empty for a generated surface
  int Level = 0;        ///< refinement of the generated surface, a sphere
  int Rings = 0;        ///< if positive, the generated surface is a torus with this number of rings
  int Vertices = 0;     ///< if positive, number of vertices to decimate to, approximate
  int Subdivisions = 0; ///< steps of Loop subdivision, each with four times the vertices

  vtkSmartPointer<vtkPolyData> Make() const;
};

/// Recipe of a graph: its mesh and options.
struct GraphRecipe
{
  MeshRecipe Mesh;
  std::string Name; ///< distinguishes the graphs of a mesh
  dgg::GraphOptions Options;
};

class BenchmarkMesh
{
public:
  explicit BenchmarkMesh(const MeshRecipe& recipe);

  /// Returns the reason why the mesh cannot be used; empty if there is none.
  const std::string& GetError() const { return this->Error; }
  const MeshArrays& GetArrays() const { return this->Arrays; }
  const dgg::SurfaceMesh& GetSurface() const { return this->Surface; }
  double GetNumberOfVertices() const
  {
    return static_cast<double>(this->Arrays.GetNumberOfVertices());
  }
  /// Returns the k-th of `numberOfSources` fixed sources: vertex n k / numberOfSources, or the next
  /// vertex that has a face.
  dgg::Id GetSource(int k, int numberOfSources) const;
  /// Returns our exact distances from a vertex, computed once.
  const std::vector<double>& GetExactDistances(dgg::Id source);
  /// Sets exact distances that are already known, to avoid their computation.
  void SetExactDistances(dgg::Id source, std::vector<double> distances);

  /// Returns random pairs of points of the mesh.
  MeasuredPairs& GetPairs(const PairRecipe& recipe);

  /// Returns a graph of the mesh. Only the last one is kept.
  MeasuredGraph& GetGraph(const GraphRecipe& recipe);

  vtkPolyData* GetPolyData() const;

private:
  std::string Error;
  vtkSmartPointer<vtkPolyData> PolyData;
  MeshArrays Arrays;
  dgg::SurfaceMesh Surface;
  std::map<dgg::Id, std::vector<double>> ExactDistances;
  std::map<PairRecipe, MeasuredPairs> Pairs;
  std::unique_ptr<MeasuredGraph> Graph;
  std::string GraphName;
};

/// Returns the mesh of a recipe. Only the last one is kept, because several large ones exceed the
/// memory.
BenchmarkMesh& GetBenchmarkMesh(const MeshRecipe& recipe);

#endif
