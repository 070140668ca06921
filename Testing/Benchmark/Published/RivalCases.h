// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Benchmarks of the methods that the thesis compares with.
#ifndef RivalCases_h
#define RivalCases_h

#include "BenchmarkArguments.h" // for the options

/// Registers the heat method and its variational form.
void RegisterHeat(const MeshRecipe& mesh, const BenchmarkArguments& arguments);
/// Registers pairs of vertices: unfolding of geodesic triangles, and the graph.
void RegisterUnfolding(const MeshRecipe& mesh, const BenchmarkArguments& arguments);
/// Registers propagation with merged windows.
void RegisterMerging(const MeshRecipe& mesh, const BenchmarkArguments& arguments);

#endif
