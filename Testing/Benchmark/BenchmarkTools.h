// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the benchmark programs share: how a case is registered, timed and reported, and the meshes
/// and graphs that it is about.
#ifndef BenchmarkTools_h
#define BenchmarkTools_h

#include "BenchmarkMesh.h"   // for BenchmarkMesh
#include "ErrorStatistics.h" // for ErrorStatistics
#include "MemoryProbe.h"     // for MemoryProbe
#include "dggParallel.h"     // for ParallelFor

#include <benchmark/benchmark.h> // for State

#include <functional> // for what is timed
#include <stdexcept>  // for errors
#include <string>     // for names
#include <utility>    // for std::move
#include <vector>     // for distances

/// Why a case, or a program, cannot go on.
class BenchmarkError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Throw that error: for a text that is not empty, a failure, or a condition that does not hold.
void Require(const std::string& error);
void Require(const dgg::Status& status);
void Require(bool condition, const std::string& error);

/// A loop on this many threads of the standard library, each taking the next piece of it when done
/// with one.
dgg::ParallelFor ThreadedLoop(int threads);

/// CPU time of this process, all threads together, in seconds.
double CPUSeconds();
/// CPU time of the calling thread, in seconds; that of the process where the system does not show.
double ThreadSeconds();
/// Time on the wall in seconds.
double WallSeconds();

using BenchmarkCase = std::function<void(benchmark::State&)>;

/// Have a case run; it repeats until it has been timed for `minimum` seconds. A BenchmarkError is
/// an error of the case.
void RegisterCase(const std::string& name, BenchmarkCase run, double minimum = 0.1);

/// The least time of cases that run once: they take several times of their own, or long.
constexpr double Once = 1e-9;

/// Cases whose names begin alike.
class CaseGroup
{
public:
  explicit CaseGroup(std::string prefix, double minimum = 0.1)
    : Prefix(std::move(prefix))
    , Minimum(minimum)
  {
  }

  /// The same with another least time.
  CaseGroup For(double minimum) const { return CaseGroup(this->Prefix, minimum); }

  /// A case that calls `run` with the state and copies of the arguments.
  template <typename Run, typename... Arguments>
  void Add(const std::string& name, Run run, const Arguments&... arguments) const
  {
    RegisterCase(
      this->Prefix + name, [=](benchmark::State& state) { run(state, arguments...); },
      this->Minimum);
  }
  /// The same for the k-th of `count` sources, which are given as well.
  template <typename Run, typename... Arguments>
  void AddSource(
    const std::string& name, int k, int count, Run run, const Arguments&... arguments) const
  {
    this->Add(name + "/" + std::to_string(k), run, arguments..., k, count);
  }
  /// The same for all of them.
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

/// One loop of Google Benchmark: `prepare` is not timed, `run` is. What it takes on the wall is
/// reported as well ("wall_seconds").
void Measure(benchmark::State& state, const std::function<void()>& prepare,
  const std::function<void()>& run, double (*clock)() = CPUSeconds);

/// The mesh of a recipe; an error when it cannot be used or has more than `limit` vertices.
BenchmarkMesh& OpenMesh(const MeshRecipe& recipe, double limit = dgg::Infinity);

struct OpenedGraph
{
  BenchmarkMesh* Mesh = nullptr;
  MeasuredGraph* Graph = nullptr;
};

/// A graph and its mesh. The graph is not necessarily built.
OpenedGraph OpenGraph(const GraphRecipe& recipe);
/// The same, built.
OpenedGraph OpenBuiltGraph(const GraphRecipe& recipe);

void ReportMesh(benchmark::State& state, const BenchmarkMesh& mesh);
void ReportMemory(benchmark::State& state, const BenchmarkMesh& mesh, const MemoryProbe& probe);
/// Errors against the exact distances of the mesh.
void ReportErrors(benchmark::State& state, BenchmarkMesh& mesh, dgg::Id source,
  const std::vector<double>& distances);
/// An error when there are none.
void ReportErrors(benchmark::State& state, const ErrorStatistics& errors);

#endif
