// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is measured of graphs of point clouds, and of marching in the band around one.
#ifndef CloudCases_h
#define CloudCases_h

#include "MeasuredCloud.h" // for recipes

#include <benchmark/benchmark.h> // for State

/// Build the graph: time on the wall, as it is built with threads; CPU time, size, what was used
/// and found, edges that lead off the surface, and the growth of the resident set.
void MeasureCloudBuild(benchmark::State& state, const CloudGraphRecipe& recipe);

/// Predict size and memory, with as many threads.
void MeasureCloudEstimate(benchmark::State& state, const CloudGraphRecipe& recipe);

/// A query from the k-th of `numberOfSources` sources to all, and its errors.
void MeasureCloudQuery(
  benchmark::State& state, const CloudGraphRecipe& recipe, int k, int numberOfSources);

/// The same by fast marching in the band of the graph, which is built if it is not there.
void MeasureBandMarching(
  benchmark::State& state, const CloudGraphRecipe& recipe, int k, int numberOfSources);

#endif
