// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A mesh and the Poisson equation on it, for one case of a benchmark.
#ifndef OpenedSolver_h
#define OpenedSolver_h

#include "BenchmarkMesh.h" // for MeshRecipe

#include "dggPoissonSolver.h" // for PoissonSolver

#include <benchmark/benchmark.h> // for State

struct OpenedSolver
{
  BenchmarkMesh* Mesh = nullptr;
  const dgg::PoissonSolver* Solver = nullptr;
};

/// The solver of a recipe, factorized; that of the last mesh is kept. Null, with the state closed,
/// when the mesh cannot be used.
OpenedSolver OpenSolver(benchmark::State& state, const MeshRecipe& recipe);

#endif
