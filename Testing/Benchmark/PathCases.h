// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Benchmarks of paths through a graph, of farthest point samples and their Voronoi cells, and of a
/// distance matrix.
#ifndef PathCases_h
#define PathCases_h

#include "BenchmarkMesh.h" // for recipes
#include "dggPathFinder.h" // for PathOptions

#include <benchmark/benchmark.h> // for State

/// Measures landmarks: wall-clock time, and the bytes that the search holds afterwards in addition
/// to those of a query, including the workspaces of all threads that computed the landmarks.
void MeasureLandmarks(benchmark::State& state, const GraphRecipe& recipe, int threads);

/// Measures a path for each pair, timed one by one; the time of the case is the mean over the
/// paths.
void MeasurePaths(benchmark::State& state, const GraphRecipe& recipe, const PairRecipe& pairs,
  const dgg::PathOptions& options, bool withLandmarks);

/// Measures VTK's paths along mesh edges between pairs of vertices.
void MeasureEdgePaths(benchmark::State& state, const MeshRecipe& recipe, const PairRecipe& pairs);

/// Measures farthest point samples at vertices, and ten queries from single vertices to all.
void MeasureFarthestPoints(benchmark::State& state, const GraphRecipe& recipe, int samples);

/// Measures the Voronoi diagram of these samples, with and without refined boundaries, its vertex
/// labels alone, and a single search from all samples, which yields labels without correction; for
/// comparison also one query.
void MeasureVoronoi(benchmark::State& state, const GraphRecipe& recipe, int samples);

/// Measures vtkGeodesicDistanceMatrix between two sets of `size` random surface points: wall-clock
/// time of an update with the graph of an earlier update, and the errors of one row. The filter
/// keeps the graph between updates.
void MeasureMatrix(
  benchmark::State& state, const MeshRecipe& recipe, double accuracy, int size, int threads);

#endif
