// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is measured of the Poisson equation and of what is made of it.
#ifndef SpectralCases_h
#define SpectralCases_h

#include "BenchmarkMesh.h" // for MeshRecipe
#include "OpenedSolver.h"  // for GreensWay

#include <benchmark/benchmark.h> // for State

/// Matrix, order of elimination and factorization; the memory that was predicted after the order
/// was known, and what was taken.
void MeasureFactor(benchmark::State& state, const MeshRecipe& recipe);

/// The Green's function of the k-th of so many vertices: one solve.
void MeasureColumn(benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources);

/// Those of as many vertices as are solved for together, all of them.
void MeasureColumnBlock(benchmark::State& state, const MeshRecipe& recipe);

/// The Green's function of the k-th of so many random points of the surface. What is kept from one
/// to the next of them, as columns of vertices, is there already; the time of the first one is
/// reported besides.
void MeasureGreens(benchmark::State& state, const MeshRecipe& recipe, const GreensWay& way, int k,
  int numberOfSources);

/// The Green's function of the bi-Laplacian of a vertex: two solves.
void MeasureBiharmonicColumn(
  benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources);

void MeasureEigenpairs(benchmark::State& state, const MeshRecipe& recipe, int count);

/// The earth mover's distance of two vertices, with the defaults, beside their geodesic distance.
void MeasureEarthMovers(benchmark::State& state, const MeshRecipe& recipe);

#endif
