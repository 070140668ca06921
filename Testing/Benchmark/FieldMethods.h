// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Methods that compute distances from a vertex, ours and those of other libraries, measured alike.

#ifndef FieldMethods_h
#define FieldMethods_h

#include "BenchmarkMesh.h" // for MeshRecipe
#ifdef DGG_WITH_HEAT
#include "PeerHeat.h" // for Triangulation
#endif

#include <benchmark/benchmark.h> // for State

#include <functional> // for the function that makes a method
#include <memory>     // for methods
#include <string>     // for names
#include <vector>     // for distances

class FieldMethod
{
public:
  virtual ~FieldMethod() = default;
  /// All that precedes queries, except the mesh of the library. Throws a BenchmarkError on failure.
  virtual void Prepare() {}
  /// Computes the distances of all vertices. Throws a BenchmarkError on failure.
  virtual void Run(dgg::Id source) = 0;
  /// Returns the distances of the last run.
  virtual std::vector<double> TakeDistances() = 0;
};

struct NamedMethod
{
  std::string Name;
  std::function<std::unique_ptr<FieldMethod>(const BenchmarkMesh&)> Make;
  bool IsPrepared = true; ///< false: nothing precedes the first query
};

NamedMethod HeatOfOurs();
NamedMethod MarchingOfOurs();
/// vtkDijkstraGraphGeodesicPath.
NamedMethod EdgesOfVTK();
#ifdef DGG_WITH_CGAL
NamedMethod ExactOfCGAL();
#endif
#ifdef DGG_WITH_HEAT
NamedMethod HeatOfCGAL(PeerHeat::Triangulation triangulation);
#endif

/// Time and memory of all that precedes queries.
void MeasurePreparation(
  benchmark::State& state, const MeshRecipe& recipe, const NamedMethod& method);
/// A query from the k-th of `numberOfSources` sources to all, on a mesh of up to `limit` vertices;
/// not the first query of a method that prepares anything.
void MeasureField(benchmark::State& state, const MeshRecipe& recipe, const NamedMethod& method,
  double limit, int k, int numberOfSources);

#endif
