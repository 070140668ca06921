// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cases that more than one program measures: our mesh, our exact engines, VTK's edge graph.
#ifndef ExactCases_h
#define ExactCases_h

#include "BenchmarkMesh.h"     // for MeshRecipe
#include "dggExactGeodesics.h" // for ExactEngine

#include <benchmark/benchmark.h> // for State

/// Build our mesh.
void MeasureSetUp(benchmark::State& state, const MeshRecipe& recipe);

/// One exact run, `k`-th of `numberOfSources` sources, on a mesh of up to `limit` vertices. Errors
/// are against engine T, whose distances are kept for the cases that follow.
void MeasureEngine(benchmark::State& state, const MeshRecipe& recipe, dgg::ExactEngine engine,
  double limit, int k, int numberOfSources);

/// One run along the edges of the mesh.
void MeasureVTK(benchmark::State& state, const MeshRecipe& recipe, int k, int numberOfSources);

#endif
