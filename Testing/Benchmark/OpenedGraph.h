// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A mesh and a graph of it, for one case of a benchmark.
#ifndef OpenedGraph_h
#define OpenedGraph_h

#include "BenchmarkMesh.h" // for GraphRecipe

#include <benchmark/benchmark.h> // for State

struct OpenedGraph
{
  BenchmarkMesh* Mesh = nullptr;
  MeasuredGraph* Graph = nullptr;
};

/// The graph of a recipe, not necessarily built; no graph, with the state closed, when the mesh
/// cannot be used.
OpenedGraph OpenGraph(benchmark::State& state, const GraphRecipe& recipe);

/// The same, built.
OpenedGraph OpenBuiltGraph(benchmark::State& state, const GraphRecipe& recipe);

/// Close the state when something failed; returns whether nothing did.
bool Succeeded(benchmark::State& state, const dgg::Status& status);

#endif
