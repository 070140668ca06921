// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is measured of farthest point samples and their Voronoi cells.
#ifndef CellCases_h
#define CellCases_h

#include "BenchmarkMesh.h" // for GraphRecipe

#include <benchmark/benchmark.h> // for State

/// Farthest point samples at vertices, beside ten queries from single vertices to all.
void MeasureFarthestPoints(benchmark::State& state, const GraphRecipe& recipe, int samples);

/// The Voronoi diagram of these samples, the same without refined borders, its labels of the
/// vertices alone, and a search from all samples at once, which gives labels without correction;
/// beside one query.
void MeasureVoronoi(benchmark::State& state, const GraphRecipe& recipe, int samples);

#endif
