// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cases that more than one program measures: our mesh and our exact engine.
#ifndef ExactCases_h
#define ExactCases_h

#include "BenchmarkMesh.h" // for MeshRecipe

#include <benchmark/benchmark.h> // for State

/// Measures the construction of a SurfaceMesh.
void MeasureSetUp(benchmark::State& state, const MeshRecipe& recipe);

/// One exact run from the k-th of `numberOfSources` sources; its distances are kept for the cases
/// that follow.
void MeasureEngine(benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources);

#endif
