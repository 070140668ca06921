// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Errors of Green's functions and B-splines on spheres of radius 1, where there is a closed form.
#ifndef ConvergenceCases_h
#define ConvergenceCases_h

#include "OpenedSolver.h" // for GreensWay

#include <benchmark/benchmark.h> // for State

/// With the icosahedron split `level` times: relative L2 errors over the vertices within 0.2 of the
/// pole and over all, means over so many poles inside of faces, and the largest error of all. The
/// poles are the same at each level, but for what the faces differ from the sphere: within a face
/// of the level before, at the same barycentric coordinates.
void MeasureConvergence(benchmark::State& state, int level, const GreensWay& way, int poles);

/// Harmonic B-splines of so many sites on such a sphere: the relative L2 error of the solution of
/// -Laplace u = 6 x z, which is x z. The time is that of sites, cells, equations and solution.
void MeasureSplines(benchmark::State& state, int level, int sites);

#endif
