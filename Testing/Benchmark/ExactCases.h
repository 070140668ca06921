// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cases that several programs measure: our mesh and our exact engine.
#ifndef ExactCases_h
#define ExactCases_h

#include "BenchmarkMesh.h" // for MeshRecipe

#include <benchmark/benchmark.h> // for State

/// Measures the construction of a SurfaceMesh.
void MeasureSetUp(benchmark::State& state, const MeshRecipe& recipe);

/// Measures one exact run from the k-th of `numberOfSources` sources. Its distances are kept for
/// later cases.
void MeasureEngine(benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources);

#endif
