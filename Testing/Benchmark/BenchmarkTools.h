// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the benchmark programs share: how a case is registered, timed and reported.
#ifndef BenchmarkTools_h
#define BenchmarkTools_h

#include "BenchmarkMesh.h"   // for BenchmarkMesh
#include "ErrorStatistics.h" // for ErrorStatistics
#include "MemoryProbe.h"     // for MemoryProbe

#include <benchmark/benchmark.h> // for State

#include <functional> // for what is timed
#include <string>     // for names
#include <vector>     // for distances

/// CPU time of this process, all threads together, in seconds.
double CPUSeconds();
/// CPU time of the calling thread, in seconds; that of the process where the system does not tell.
double ThreadSeconds();
/// Time on the wall in seconds.
double WallSeconds();

using BenchmarkCase = std::function<void(benchmark::State&)>;

/// Have a case run; it repeats until it has been timed for `minimum` seconds.
void RegisterCase(const std::string& name, BenchmarkCase run, double minimum = 0.1);

/// One loop of Google Benchmark: `prepare` is not timed, `run` is. What it takes on the wall is
/// reported as well ("wall_seconds").
void Measure(benchmark::State& state, const std::function<void()>& prepare,
  const std::function<void()>& run, double (*clock)() = CPUSeconds);

/// The mesh of a recipe; null, with the state closed, when it cannot be used or has more than
/// `limit` vertices.
BenchmarkMesh* OpenMesh(
  benchmark::State& state, const MeshRecipe& recipe, double limit = dgg::Infinity);

void ReportMesh(benchmark::State& state, const BenchmarkMesh& mesh);
void ReportMemory(benchmark::State& state, const BenchmarkMesh& mesh, const MemoryProbe& probe);
/// Errors against the exact distances of the mesh.
void ReportErrors(benchmark::State& state, BenchmarkMesh& mesh, dgg::Id source,
  const std::vector<double>& distances);
/// An error of the case when there are none.
void ReportErrors(benchmark::State& state, const ErrorStatistics& errors);

#endif
