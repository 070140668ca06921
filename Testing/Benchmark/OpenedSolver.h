// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A mesh and the Poisson equation on it, for one case of a benchmark.
#ifndef OpenedSolver_h
#define OpenedSolver_h

#include "BenchmarkMesh.h" // for MeshRecipe

#include "dggPoissonSolver.h" // for PoissonSolver

#include <benchmark/benchmark.h> // for State

#include <vector> // for loads

struct OpenedSolver
{
  BenchmarkMesh* Mesh = nullptr;
  const dgg::PoissonSolver* Solver = nullptr;
};

/// The solver of a recipe, factorized; that of the last mesh is kept. Null, with the state closed,
/// when the mesh cannot be used.
OpenedSolver OpenSolver(benchmark::State& state, const MeshRecipe& recipe);

/// One at a vertex, 0 at others.
std::vector<double> UnitLoad(const dgg::PoissonSolver& solver, dgg::Id vertex);

/// The Green's function of a vertex: of the Laplacian for the power 1, of the bi-Laplacian for 2.
dgg::Status FindColumn(
  const dgg::PoissonSolver& solver, dgg::Id source, int power, std::vector<double>& values);

#endif
