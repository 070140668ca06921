// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL's heat method, measured as a graph is: what comes before, the first query, later ones.
#ifndef HeatCases_h
#define HeatCases_h

#include "BenchmarkMesh.h" // for MeshRecipe
#include "PeerHeat.h"      // for PeerHeat

#include <benchmark/benchmark.h> // for State

/// The two factorisations, CGAL's own mesh apart.
void MeasureHeatPrecomputation(
  benchmark::State& state, const MeshRecipe& recipe, PeerHeat::Triangulation triangulation);
/// A query from the k-th of `numberOfSources` sources to all; the first one costs the same.
void MeasureHeatQuery(benchmark::State& state, const MeshRecipe& recipe,
  PeerHeat::Triangulation triangulation, int k, int numberOfSources);

#endif
