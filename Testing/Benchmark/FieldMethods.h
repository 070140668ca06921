// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Methods that compute distances from a vertex, ours and those of other libraries, measured in the
/// same manner.

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
  /// Runs all steps that precede queries, except the construction of the library's mesh. Throws a
  /// BenchmarkError on failure.
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

#endif
