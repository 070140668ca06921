// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A mesh under measurement, in the form that each peer wants, with the exact answers.
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

/// How to get a mesh: from a file or a generator, and then coarser or finer.
struct MeshRecipe
{
  std::string Name;
  std::string File;     ///< empty: a generated surface
  int Level = 0;        ///< refinement of the generated surface, a sphere
  int Rings = 0;        ///< when positive: the generated surface is a torus of so many rings
  int Vertices = 0;     ///< when positive: decimate to about this many
  int Subdivisions = 0; ///< steps of Loop subdivision, each with four times the vertices

  vtkSmartPointer<vtkPolyData> Make() const;
};

/// Which graph of which mesh.
struct GraphRecipe
{
  MeshRecipe Mesh;
  std::string Name; ///< shows the graphs of one mesh apart
  dgg::GraphOptions Options;
};

class BenchmarkMesh
{
public:
  explicit BenchmarkMesh(const MeshRecipe& recipe);

  /// Why the mesh cannot be used; empty when it can.
  const std::string& GetError() const { return this->Error; }
  const MeshArrays& GetArrays() const { return this->Arrays; }
  const dgg::SurfaceMesh& GetSurface() const { return this->Surface; }
  double GetNumberOfVertices() const
  {
    return static_cast<double>(this->Arrays.GetNumberOfVertices());
  }
  /// The k-th of so many fixed sources: vertex n k / numberOfSources, or the next one that has a
  /// face.
  dgg::Id GetSource(int k, int numberOfSources) const;
  /// Our exact distances from a vertex, computed once.
  const std::vector<double>& GetExactDistances(dgg::Id source);
  /// Give them when they are known, to save that run.
  void SetExactDistances(dgg::Id source, std::vector<double> distances);

  /// Random pairs of points of the mesh.
  MeasuredPairs& GetPairs(const PairRecipe& recipe);

  /// A graph of the mesh. Only the last one is kept.
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

/// The mesh of a recipe. Only the last one is kept: the large ones do not fit together.
BenchmarkMesh& GetBenchmarkMesh(const MeshRecipe& recipe);

#endif
