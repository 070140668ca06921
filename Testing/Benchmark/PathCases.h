// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is measured of paths through a graph, of farthest point samples and their Voronoi cells,
/// and of a matrix of distances.
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

/// Farthest point samples at vertices, beside ten queries from single vertices to all.
void MeasureFarthestPoints(benchmark::State& state, const GraphRecipe& recipe, int samples);

/// The Voronoi diagram of these samples, the same without refined borders, its labels of the
/// vertices alone, and a search from all samples at once, which gives labels without correction;
/// beside one query.
void MeasureVoronoi(benchmark::State& state, const GraphRecipe& recipe, int samples);

/// vtkGeodesicDistanceMatrix between two sets of so many random points anywhere on the surface:
/// time on the wall of an update with the graph kept from an earlier one, and the errors of one
/// row. What carries the graph across updates is the filter.
void MeasureMatrix(
  benchmark::State& state, const MeshRecipe& recipe, double accuracy, int size, int threads);

#endif
