// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkTools.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>

void Require(const std::string& error)
{
  Require(error.empty(), error);
}

void Require(const dgg::Status& status)
{
  Require(status.IsOk(), status.GetMessage());
}

void Require(bool condition, const std::string& error)
{
  if (!condition)
  {
    throw BenchmarkError(error);
  }
}

dgg::ParallelFor ThreadedLoop(int threads)
{
  return [threads](dgg::Offset size, dgg::Offset grain,
           const std::function<void(dgg::Offset, dgg::Offset)>& body) {
    const dgg::Offset step = std::max<dgg::Offset>(1, grain);
    std::atomic<dgg::Offset> next{ 0 };
    const auto work = [&] {
      for (dgg::Offset begin = next.fetch_add(step); begin < size; begin = next.fetch_add(step))
      {
        body(begin, std::min(begin + step, size));
      }
    };
    std::vector<std::thread> helpers;
    for (int i = 1; i < threads; ++i)
    {
      helpers.emplace_back(work);
    }
    work();
    for (std::thread& helper : helpers)
    {
      helper.join();
    }
  };
}

double CPUSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double ThreadSeconds()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec time;
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0)
  {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
#endif
  return CPUSeconds();
}

double WallSeconds()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

void RegisterCase(const std::string& name, BenchmarkCase run, double minimum)
{
  const auto report = [run = std::move(run)](benchmark::State& state) {
    try
    {
      run(state);
    }
    catch (const BenchmarkError& error)
    {
      state.SkipWithError(error.what());
    }
  };
  benchmark::RegisterBenchmark(name.c_str(), report)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->MinTime(minimum);
}

void Measure(benchmark::State& state, const std::function<void()>& prepare,
  const std::function<void()>& run, double (*clock)())
{
  double onTheWall = 0.0;
  for (auto unused : state)
  {
    (void)unused;
    prepare();
    const double wallStart = WallSeconds();
    const double start = clock();
    run();
    state.SetIterationTime(clock() - start);
    onTheWall += WallSeconds() - wallStart;
  }
  state.counters["wall_seconds"] =
    benchmark::Counter(onTheWall, benchmark::Counter::kAvgIterations);
}

BenchmarkMesh& OpenMesh(const MeshRecipe& recipe, double limit)
{
  BenchmarkMesh& mesh = GetBenchmarkMesh(recipe);
  Require(mesh.GetError());
  Require(mesh.GetNumberOfVertices() <= limit, "above the limit of vertices");
  return mesh;
}

OpenedGraph OpenGraph(const GraphRecipe& recipe)
{
  BenchmarkMesh& mesh = OpenMesh(recipe.Mesh);
  return { &mesh, &mesh.GetGraph(recipe) };
}

OpenedGraph OpenBuiltGraph(const GraphRecipe& recipe)
{
  const OpenedGraph opened = OpenGraph(recipe);
  opened.Graph->NeedGraph();
  Require(opened.Graph->GetError());
  return opened;
}

void ReportMesh(benchmark::State& state, const BenchmarkMesh& mesh)
{
  state.counters["vertices"] = mesh.GetNumberOfVertices();
  state.counters["faces"] = static_cast<double>(mesh.GetArrays().GetNumberOfFaces());
}

void ReportMemory(benchmark::State& state, const BenchmarkMesh& mesh, const MemoryProbe& probe)
{
  const double vertices = mesh.GetNumberOfVertices();
  state.counters["heap_bytes_per_vertex"] = static_cast<double>(probe.GetHeapPeak()) / vertices;
  state.counters["resident_bytes_per_vertex"] =
    static_cast<double>(probe.GetResidentPeak()) / vertices;
}

void ReportErrors(benchmark::State& state, BenchmarkMesh& mesh, dgg::Id source,
  const std::vector<double>& distances)
{
  ReportErrors(state, ErrorStatistics(distances, mesh.GetExactDistances(source)));
}

void ReportErrors(benchmark::State& state, const ErrorStatistics& errors)
{
  Require(errors.Errors.GetCount() > 0, "no vertex with a true distance is reached");
  state.counters["error_mean"] = errors.Errors.GetMean();
  state.counters["error_p999"] = errors.GetPercentile999();
  state.counters["error_max"] = errors.Errors.GetMaximum();
  state.counters["unreached"] = static_cast<double>(errors.Unreached);
  state.counters["reached_beyond"] = static_cast<double>(errors.Beyond);
}
