// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LoopCases.h"

#include "BenchmarkTools.h"
#include "SampleStatistics.h"
#include "dggHandleLoops.h"
#include "dggLoopFinder.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr int Repetitions = 3;

/// Loops that were found, the shortest of them, and those that are none.
class LoopCount
{
public:
  explicit LoopCount(const BenchmarkMesh& mesh)
    : Mesh(mesh)
  {
  }

  void Add(const dgg::FoundLoop& found)
  {
    if (found.Loop.IsEmpty())
    {
      ++this->Empty;
      return;
    }
    this->Length.Add(found.Loop.Length);
    const bool isLoop =
      this->IsClosed(found.Loop) && dgg::CheckPath(this->Mesh.GetSurface(), found.Loop).IsOk();
    this->Invalid += isLoop ? 0 : 1;
  }

  void Report(benchmark::State& state) const
  {
    state.counters["loops"] = static_cast<double>(this->Length.GetCount());
    state.counters["empty"] = this->Empty;
    state.counters["shortest"] = this->Length.GetMinimum();
    state.counters["invalid"] = this->Invalid;
  }

private:
  /// In space, up to rounding: the same place on an edge may be given in two faces.
  bool IsClosed(const dgg::SurfacePath& path) const
  {
    const double* positions = this->Mesh.GetArrays().Points.data();
    const auto p = dgg::PositionOf(this->Mesh.GetSurface(), path.Points.front(), positions);
    const auto q = dgg::PositionOf(this->Mesh.GetSurface(), path.Points.back(), positions);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= 1e-9 * path.Length;
  }

  const BenchmarkMesh& Mesh;
  SampleStatistics Length;
  int Empty = 0; // not found, or one that cannot be moved
  int Invalid = 0;
};

/// Times of some runs, what they found and whether all went well.
struct LoopRuns
{
  SampleStatistics Seconds;
  dgg::Status Status;

  /// Time `find`, unless an earlier run failed.
  template <typename FindType>
  void Run(FindType find)
  {
    if (this->Status.IsOk())
    {
      const double start = ThreadSeconds();
      this->Status = find();
      this->Seconds.Add(ThreadSeconds() - start);
    }
  }

  void Report(benchmark::State& state, const BenchmarkMesh& mesh, const LoopCount& loops) const
  {
    Require(this->Status);
    ReportMesh(state, mesh);
    state.counters["runs"] = static_cast<double>(this->Seconds.GetCount());
    state.counters["ms_max"] = 1e3 * this->Seconds.GetMaximum();
    loops.Report(state);
  }
};
}

void MeasureAroundHandles(benchmark::State& state, const MeshRecipe& recipe)
{
  const BenchmarkMesh& mesh = OpenMesh(recipe);
  LoopRuns runs;
  LoopCount loops(mesh);
  for (auto unused : state)
  {
    (void)unused;
    for (int k = 0; k < Repetitions; ++k)
    {
      std::vector<dgg::FoundLoop> found;
      runs.Run([&] { return dgg::FindHandleLoops(mesh.GetSurface(), nullptr, found); });
      std::for_each(
        found.begin(), found.end(), [&](const dgg::FoundLoop& loop) { loops.Add(loop); });
    }
    state.SetIterationTime(runs.Seconds.GetQuantile(0.5));
  }
  runs.Report(state, mesh, loops);
}

void MeasureThroughPoint(benchmark::State& state, const GraphRecipe& recipe, int points, bool taut)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  const dgg::LoopFinder finder(opened.Mesh->GetSurface(), opened.Graph->GetSearch(),
    &opened.Graph->GetBuilder(), opened.Mesh->GetArrays().Points.data());
  LoopRuns runs;
  LoopCount loops(*opened.Mesh);
  for (auto unused : state)
  {
    (void)unused;
    for (int k = 0; k < points; ++k)
    {
      const auto point = dgg::SurfacePoint::AtVertex(opened.Mesh->GetSource(k, points));
      dgg::FoundLoop found;
      runs.Run([&] { return finder.ThroughPoint(point, taut, found); });
      loops.Add(found);
    }
    state.SetIterationTime(runs.Seconds.GetQuantile(0.5));
  }
  runs.Report(state, *opened.Mesh, loops);
}
