// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Common functions of the benchmark programs: registration, timing and reports of cases, and their
/// meshes and graphs.
#ifndef BenchmarkTools_h
#define BenchmarkTools_h

#include "BenchmarkMesh.h" // for BenchmarkMesh
#include "MemoryProbe.h"   // for MemoryProbe
#include "Statistics.h"    // for ErrorStatistics
#include "dggParallel.h"   // for ParallelFor

#include <benchmark/benchmark.h> // for State

#include <functional> // for what is timed
#include <stdexcept>  // for errors
#include <string>     // for names
#include <utility>    // for std::move
#include <vector>     // for distances

/// Reason why a case or a program cannot continue.
class BenchmarkError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Throws a BenchmarkError for a non-empty text, a failure, or a condition that is false.
void Require(const std::string& error);
void Require(const dgg::Status& status);
void Require(bool condition, const std::string& error);

/// Returns a loop on `threads` threads of the standard library; each thread takes the next range
/// when it has finished one.
dgg::ParallelFor ThreadedLoop(int threads);

/// Returns the CPU time of this process, all threads together, in seconds.
double CPUSeconds();
/// Returns the CPU time of the calling thread, in seconds; of the process if the system does not
/// report it per thread.
double ThreadSeconds();
/// Returns the wall-clock time in seconds.
double WallSeconds();

using BenchmarkCase = std::function<void(benchmark::State&)>;

/// Registers a case that is repeated until `minimum` seconds have been timed. A BenchmarkError
/// becomes an error of the case.
void RegisterCase(const std::string& name, BenchmarkCase run, double minimum = 0.1);

/// Value of `minimum` for cases that run once, because they take long or measure several times
/// themselves.
constexpr double Once = 1e-9;

/// Cases whose names have a common prefix.
class CaseGroup
{
public:
  explicit CaseGroup(std::string prefix, double minimum = 0.1)
    : Prefix(std::move(prefix))
    , Minimum(minimum)
  {
  }

  /// Returns the same group with another minimum time.
  CaseGroup For(double minimum) const { return CaseGroup(this->Prefix, minimum); }

  /// Registers a case that calls `run` with the state and copies of the arguments.
  template <typename Run, typename... Arguments>
  void Add(const std::string& name, Run run, const Arguments&... arguments) const
  {
    RegisterCase(
      this->Prefix + name, [=](benchmark::State& state) { run(state, arguments...); },
      this->Minimum);
  }
  /// Registers a case for the k-th of `count` sources; `run` also receives k and `count`.
  template <typename Run, typename... Arguments>
  void AddSource(
    const std::string& name, int k, int count, Run run, const Arguments&... arguments) const
  {
    this->Add(name + "/" + std::to_string(k), run, arguments..., k, count);
  }
  /// Registers cases for all `count` sources, see AddSource().
  template <typename Run, typename... Arguments>
  void AddSources(const std::string& name, int count, Run run, const Arguments&... arguments) const
  {
    for (int k = 0; k < count; ++k)
    {
      this->AddSource(name, k, count, run, arguments...);
    }
  }

private:
  std::string Prefix;
  double Minimum;
};

/// Runs the loop of Google Benchmark. `prepare` is not timed, `run` is. Also reports the wall-clock
/// time of `run` ("wall_seconds").
void Measure(benchmark::State& state, const std::function<void()>& prepare,
  const std::function<void()>& run, double (*clock)() = CPUSeconds);

/// Returns the mesh of a recipe; throws if it cannot be used or has more than `limit` vertices.
BenchmarkMesh& OpenMesh(const MeshRecipe& recipe, double limit = dgg::Infinity);

struct OpenedGraph
{
  BenchmarkMesh* Mesh = nullptr;
  MeasuredGraph* Graph = nullptr;
};

/// Returns a graph, which need not be built, and its mesh.
OpenedGraph OpenGraph(const GraphRecipe& recipe);
/// Returns a graph that has been built, and its mesh.
OpenedGraph OpenBuiltGraph(const GraphRecipe& recipe);

void ReportMesh(benchmark::State& state, const BenchmarkMesh& mesh);
void ReportMemory(benchmark::State& state, const BenchmarkMesh& mesh, const MemoryProbe& probe);
/// Reports errors relative to the exact distances of the mesh.
void ReportErrors(benchmark::State& state, BenchmarkMesh& mesh, dgg::Id source,
  const std::vector<double>& distances);
/// Reports errors; throws if there are none.
void ReportErrors(benchmark::State& state, const ErrorStatistics& errors);

#endif
