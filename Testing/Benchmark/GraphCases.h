// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Benchmarks of graphs: construction, single queries and many queries.
#ifndef GraphCases_h
#define GraphCases_h

#include "BenchmarkMesh.h"  // for GraphRecipe
#include "dggGraphSearch.h" // for SearchMethod

#include <benchmark/benchmark.h> // for State

/// Measures the CPU time of a build on one thread; reports size, degree, windows and memory.
void MeasureBuild(benchmark::State& state, const GraphRecipe& recipe);
/// Measures the peak memory of a build as the system reports it, including tables and workspaces.
void MeasureMemory(benchmark::State& state, const GraphRecipe& recipe);
/// Measures the wall-clock time with several threads; reports if the graph is the same bit by bit.
void MeasureParallelBuild(benchmark::State& state, const GraphRecipe& recipe, int threads);
/// Measures the prediction of size and memory; reports predicted and actual values.
void MeasureEstimate(benchmark::State& state, const GraphRecipe& recipe);

/// Measures the preparation of the search before the first query (fans, vertex order).
void MeasureCache(benchmark::State& state, const GraphRecipe& recipe);
/// Measures this preparation and the first query, with correction.
void MeasureFirstQuery(benchmark::State& state, const GraphRecipe& recipe);
/// Measures a query from the k-th of `numberOfSources` sources to all.
void MeasureQuery(benchmark::State& state, const GraphRecipe& recipe, dgg::SearchMethod method,
  bool correct, int k, int numberOfSources);
/// Measures queries from many sources to all, in blocks.
void MeasureMany(
  benchmark::State& state, const GraphRecipe& recipe, int numberOfSources, int threads);

#endif
