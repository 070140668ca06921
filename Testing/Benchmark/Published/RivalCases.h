// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The methods that the thesis compares with, measured.
#ifndef RivalCases_h
#define RivalCases_h

#include "BenchmarkArguments.h" // for the options

/// The heat method and its variational form.
void RegisterHeat(const MeshRecipe& mesh, const BenchmarkArguments& arguments);
/// Pairs of vertices: unfolding of geodesic triangles, and the graph.
void RegisterUnfolding(const MeshRecipe& mesh, const BenchmarkArguments& arguments);
/// Propagation with merged windows.
void RegisterMerging(const MeshRecipe& mesh, const BenchmarkArguments& arguments);

#endif
