// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is measured of isolines.
#ifndef IsolineCases_h
#define IsolineCases_h

#include "BenchmarkMesh.h" // for MeshRecipe
#include "MeasuredField.h" // for FieldInput

#include <benchmark/benchmark.h> // for State

/// A field of distances and so many of its levels, evenly spread over the range of the exact ones.
struct IsolineRecipe
{
  MeshRecipe Mesh;
  FieldInput Input = FieldInput::Exact;
  double Accuracy = 0.01; ///< of the graph
  int Levels = 20;
};

/// How isolines are traced in the kernel.
enum class IsolineKind
{
  Windows, ///< local sources: exact ones
  Sources, ///< local sources: virtual ones
  Fitted   ///< local sources: virtual ones, from the distances alone
};

/// The error of the distances at vertices.
void MeasureInput(benchmark::State& state, const IsolineRecipe& recipe);

/// vtkContourFilter, linear in triangles.
void MeasureContour(benchmark::State& state, const IsolineRecipe& recipe);

/// `chord` is the tolerance in mean edge lengths. Fitting is part of the time.
void MeasureIsolines(
  benchmark::State& state, const IsolineRecipe& recipe, IsolineKind kind, double chord);

/// The published method, with the virtual sources of the input.
void MeasureApollonius(benchmark::State& state, const IsolineRecipe& recipe, int steinerPoints);

#endif
