// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathCases.h"

#include "BenchmarkTools.h"
#include "PathStatistics.h"
#include "PeerVTK.h"

#include <cmath>

namespace
{
/// Returns the search of a graph, with or without landmarks.
const dgg::GraphSearch& SearchOf(MeasuredGraph& graph, bool withLandmarks)
{
  if (withLandmarks)
  {
    graph.NeedLandmarks();
  }
  else if (graph.GetSearch().HasLandmarks())
  {
    graph.PrepareSearch();
  }
  return graph.GetSearch();
}

}

void MeasureLandmarks(benchmark::State& state, const GraphRecipe& recipe, int threads)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  dgg::GraphSearch search(opened.Graph->GetGraph().View(), &opened.Mesh->GetSurface());
  // The preparation of the first query does not belong to the landmarks.
  dgg::SearchResult result;
  dgg::Status status = search.Run({ dgg::GraphSeed{ 0 } }, {}, result);
  const std::size_t before = search.GetMemorySize();
  Measure(
    state, [] {}, [&] { status = search.PrepareLandmarks(ThreadedLoop(threads), nullptr); },
    WallSeconds);
  Require(status);
  state.counters["threads"] = threads;
  state.counters["landmark_bytes"] = static_cast<double>(search.GetMemorySize() - before);
}

void MeasurePaths(benchmark::State& state, const GraphRecipe& recipe, const PairRecipe& pairs,
  const dgg::PathOptions& options, bool withLandmarks)
{
  const OpenedGraph opened = OpenBuiltGraph(recipe);
  const dgg::SurfaceMesh& surface = opened.Mesh->GetSurface();
  MeasuredPairs& measured = opened.Mesh->GetPairs(pairs);
  const std::vector<double>& exact = measured.GetExactDistances();
  const dgg::PathFinder finder(surface, SearchOf(*opened.Graph, withLandmarks),
    &opened.Graph->GetBuilder(), opened.Mesh->GetArrays().Points.data());
  PathStatistics statistics;
  dgg::FoundPath found;
  // The first path is not measured.
  dgg::Status status = finder.Find(measured.GetStart(0), measured.GetEnd(0), options, found);
  for (auto unused : state)
  {
    (void)unused;
    statistics = PathStatistics();
    double sum = 0.0;
    for (std::size_t i = 0; i < measured.GetCount() && status.IsOk(); ++i)
    {
      const double start = ThreadSeconds();
      status = finder.Find(measured.GetStart(i), measured.GetEnd(i), options, found);
      const double seconds = ThreadSeconds() - start;
      sum += seconds;
      const bool exists = !found.Path.IsEmpty();
      statistics.AddLength(seconds, exists ? found.Path.Length : dgg::Infinity, exact[i]);
    }
    state.SetIterationTime(sum / static_cast<double>(measured.GetCount()));
  }
  Require(status);
  ReportMesh(state, *opened.Mesh);
  statistics.Report(state);
}

void MeasureEdgePaths(benchmark::State& state, const MeshRecipe& recipe, const PairRecipe& pairs)
{
  BenchmarkMesh& mesh = OpenMesh(recipe);
  MeasuredPairs& measured = mesh.GetPairs(pairs);
  const std::vector<double>& exact = measured.GetExactDistances();
  PeerVTK peer(mesh.GetPolyData());
  PathStatistics statistics;
  for (auto unused : state)
  {
    (void)unused;
    statistics = PathStatistics();
    double sum = 0.0;
    for (std::size_t i = 0; i < measured.GetCount(); ++i)
    {
      const double start = ThreadSeconds();
      // The peer cannot handle a missing path.
      const double length = std::isfinite(exact[i])
        ? peer.FindPath(measured.GetStart(i).Vertex, measured.GetEnd(i).Vertex)
        : dgg::Infinity;
      const double seconds = ThreadSeconds() - start;
      sum += seconds;
      statistics.AddLength(seconds, length, exact[i]);
    }
    state.SetIterationTime(sum / static_cast<double>(measured.GetCount()));
  }
  ReportMesh(state, mesh);
  statistics.Report(state);
}
