// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cases that several programs measure: our mesh, our exact engine, and other methods that compute
/// distances from a vertex, ours and those of other libraries.

#ifndef FieldMethods_h
#define FieldMethods_h

#include "BenchmarkMesh.h" // for MeshRecipe
#ifdef DGG_WITH_HEAT
#include "PeerHeat.h" // for Triangulation
#endif

#include <benchmark/benchmark.h> // for State

#include <functional> // for methods
#include <string>     // for names
#include <vector>     // for distances

/// A method on a mesh. Functions throw a BenchmarkError on failure.
struct FieldMethod
{
  /// Runs all steps that precede queries, except the construction of the library's mesh.
  std::function<void()> Prepare;
  /// Computes the distances of all vertices from a vertex.
  std::function<void(dgg::Id)> Run;
  /// Returns the distances of the last run.
  std::function<std::vector<double>()> TakeDistances;
};

struct NamedMethod
{
  std::string Name;
  std::function<FieldMethod(const BenchmarkMesh&)> Make;
  bool IsPrepared = true; ///< false if no step precedes the first query
};

NamedMethod HeatOfOurs();
NamedMethod MarchingOfOurs();
/// Returns the method of vtkDijkstraGraphGeodesicPath.
NamedMethod EdgesOfVTK();
#ifdef DGG_WITH_CGAL
NamedMethod ExactOfCGAL();
#endif
#ifdef DGG_WITH_HEAT
NamedMethod HeatOfCGAL(PeerHeat::Triangulation triangulation);
#endif

/// Measures time and memory of all steps that precede queries.
void MeasurePreparation(
  benchmark::State& state, const MeshRecipe& recipe, const NamedMethod& method);
/// Measures a query from the k-th of `numberOfSources` sources to all, on a mesh of up to `limit`
/// vertices. The first query of a method with a preparation is not measured.
void MeasureField(benchmark::State& state, const MeshRecipe& recipe, const NamedMethod& method,
  double limit, int k, int numberOfSources);

/// Measures the construction of a SurfaceMesh.
void MeasureSetUp(benchmark::State& state, const MeshRecipe& recipe);

/// Measures one exact run from the k-th of `numberOfSources` sources. Its distances are kept for
/// later cases.
void MeasureEngine(benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources);

#endif
