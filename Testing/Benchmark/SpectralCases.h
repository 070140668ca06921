// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Benchmarks of the Poisson equation and its applications.
#ifndef SpectralCases_h
#define SpectralCases_h

#include "BenchmarkMesh.h" // for MeshRecipe
#include "OpenedSolver.h"  // for GreensWay

#include <benchmark/benchmark.h> // for State

/// Measures matrix, elimination ordering and factorization; reports the memory that was predicted
/// after the ordering, and the memory used.
void MeasureFactor(benchmark::State& state, const MeshRecipe& recipe);

/// Measures the Green's function of the k-th of `numberOfSources` vertices: one solve.
void MeasureColumn(benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources);

/// Measures the Green's functions of a block of vertices that are solved for together.
void MeasureColumnBlock(benchmark::State& state, const MeshRecipe& recipe);

/// Measures the Green's function of the k-th of `numberOfSources` random surface points. Data kept
/// between points, such as columns of vertices, already exist; the time of the first point is
/// reported separately.
void MeasureGreens(benchmark::State& state, const MeshRecipe& recipe, const GreensWay& way, int k,
  int numberOfSources);

/// Measures the Green's function of the bi-Laplacian at a vertex: two solves.
void MeasureBiharmonicColumn(
  benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources);

void MeasureEigenpairs(benchmark::State& state, const MeshRecipe& recipe, int count);

/// Measures the earth mover's distance between two vertices, with default options; reports their
/// geodesic distance as well.
void MeasureEarthMovers(benchmark::State& state, const MeshRecipe& recipe);

#endif
