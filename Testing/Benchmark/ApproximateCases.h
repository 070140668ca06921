// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Our heat method and fast marching, measured as the heat method of others is.
#ifndef ApproximateCases_h
#define ApproximateCases_h

#include "BenchmarkMesh.h" // for MeshRecipe

#include <benchmark/benchmark.h> // for State

/// Flips, matrices and their factorizations.
void MeasureHeatFactors(benchmark::State& state, const MeshRecipe& recipe);
/// A query from the k-th of `numberOfSources` sources to all, not the first one.
void MeasureHeatField(
  benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources);

/// Triangles unfolded.
void MeasureMarchingTables(benchmark::State& state, const MeshRecipe& recipe);
void MeasureMarchingField(
  benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources);

#endif
