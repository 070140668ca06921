// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is measured of a matrix of distances.
#ifndef MatrixCases_h
#define MatrixCases_h

#include "BenchmarkMesh.h" // for MeshRecipe

#include <benchmark/benchmark.h> // for State

/// vtkGeodesicDistanceMatrix between two sets of so many random points anywhere on the surface:
/// time on the wall of an update with the graph kept from an earlier one, and the errors of one
/// row. What carries the graph across updates is the filter.
void MeasureMatrix(
  benchmark::State& state, const MeshRecipe& recipe, double accuracy, int size, int threads);

#endif
