// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is measured of paths through a graph.
#ifndef PathCases_h
#define PathCases_h

#include "BenchmarkMesh.h" // for recipes
#include "dggPathFinder.h" // for PathOptions

#include <benchmark/benchmark.h> // for State

/// Distances of landmarks: time on the wall, and the bytes that the search holds afterwards besides
/// those of a query, so also the workspaces of all threads that found them.
void MeasureLandmarks(benchmark::State& state, const GraphRecipe& recipe, int threads);

/// A path for each of the pairs, timed one by one; the time of the case is that of the mean path.
void MeasurePaths(benchmark::State& state, const GraphRecipe& recipe, const PairRecipe& pairs,
  const dgg::PathOptions& options, bool withLandmarks);

/// Paths along mesh edges between pairs of vertices, as VTK finds them.
void MeasureEdgePaths(benchmark::State& state, const MeshRecipe& recipe, const PairRecipe& pairs);

#endif
