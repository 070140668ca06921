// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Benchmarks of graphs: construction, single queries and many queries.
#ifndef GraphCases_h
#define GraphCases_h

#include "BenchmarkMesh.h"  // for GraphRecipe
#include "dggGraphSearch.h" // for SearchMethod

#include <benchmark/benchmark.h> // for State

/// CPU time on one thread; size, degree, windows and memory.
void MeasureBuild(benchmark::State& state, const GraphRecipe& recipe);
/// The peak of memory that the system says building takes, tables and workspaces included.
void MeasureMemory(benchmark::State& state, const GraphRecipe& recipe);
/// Time on the wall with several threads, and whether the graph is the same bit by bit.
void MeasureParallelBuild(benchmark::State& state, const GraphRecipe& recipe, int threads);
/// The prediction of size and memory, against what they turn out to be.
void MeasureEstimate(benchmark::State& state, const GraphRecipe& recipe);

/// What the search prepares before the first query (fans, vertex order).
void MeasureCache(benchmark::State& state, const GraphRecipe& recipe);
/// That and the first query, with correction.
void MeasureFirstQuery(benchmark::State& state, const GraphRecipe& recipe);
/// A query from the k-th of `numberOfSources` sources to all.
void MeasureQuery(benchmark::State& state, const GraphRecipe& recipe, dgg::SearchMethod method,
  bool correct, int k, int numberOfSources);
/// Queries from many sources to all, in blocks.
void MeasureMany(
  benchmark::State& state, const GraphRecipe& recipe, int numberOfSources, int threads);

#endif
