// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is measured of closed geodesics.
#ifndef LoopCases_h
#define LoopCases_h

#include "BenchmarkMesh.h" // for recipes

#include <benchmark/benchmark.h> // for State

/// Loops around the handles of all components, found without a graph. The time is the median of a
/// few runs.
void MeasureAroundHandles(benchmark::State& state, const MeshRecipe& recipe);

/// Loops through vertices, let go there if `taut`. The time is the median of all.
void MeasureThroughPoint(benchmark::State& state, const GraphRecipe& recipe, int points, bool taut);

#endif
