// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphDistances.h"

#include "dggDistanceMethods.h"
#include "dggDistanceOutput.h"
#include "dggExactGeodesics.h"
#include "dggGraphSession.h"
#include "dggMeshQuality.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggSourceFinding.h"

#include <algorithm>
#include <utility>

namespace dgg
{
namespace
{
/// Progress after the search, if windows follow.
constexpr double SearchedAt = 0.5;

/// Returns the values at the given vertices.
template <typename Value>
std::vector<Value> Select(const std::vector<Value>& values, const std::vector<Id>& vertices)
{
  std::vector<Value> selected(vertices.size());
  std::transform(
    vertices.begin(), vertices.end(), selected.begin(), [&](Id vertex) { return values[vertex]; });
  return selected;
}

/// Fills the arrays of a task with lengths of paths.
void FillArrays(const SearchResult& result, DistanceTask& task)
{
  for (VertexArray& array : task.Arrays)
  {
    array.Components = { task.IsSparse ? Select(result.Distances, task.Vertices)
                                       : result.Distances };
  }
}

/// Moves the requested values of a search to the task.
void TakeResults(
  const std::vector<GraphSeed>& seeds, bool correct, SearchResult& result, DistanceTask& task)
{
  task.IsSparse = task.MayBeSparse && !task.WantVirtualSource && result.IsLocal();
  if (task.IsSparse)
  {
    task.Vertices = result.Reached;
  }
  const auto take = [&](auto& values) {
    return task.IsSparse ? Select(values, task.Vertices) : std::move(values);
  };
  if (task.WantNearestSource)
  {
    task.NearestSource = take(result.Seeds);
    for (Id& index : task.NearestSource)
    {
      index = index == NoId ? NoId : seeds[index].Source;
    }
  }
  FillArrays(result, task);
  task.Distances = take(correct ? result.Corrected : result.Distances);
}
}

Status FindGraphDistances(const TaskContext& context, GraphSession& graph, SearchMethod method,
  bool correct, DistanceTask& task)
{
  const bool isCorrected = correct && !context.Surface.IsCloud();
  std::vector<GraphSeed> seeds;
  DGG_RETURN_IF_ERROR(graph.MakeSeeds(context, task.Sources, seeds));
  const ProgressCallback progress = graph.GetRemainingProgress(context);
  SearchOptions options;
  options.Method = method;
  options.Correct = isCorrected || task.WantVirtualSource;
  options.MaximumDistance =
    isCorrected ? graph.WidenLimit(task.MaximumDistance, task.Sources) : task.MaximumDistance;
  options.Progress = task.WantVirtualSource ? ProgressPart(progress, 0.0, SearchedAt) : progress;
  SearchResult& result = graph.GetResult();
  DGG_RETURN_IF_ERROR(graph.GetSearch().Run(seeds, options, result));
  if (isCorrected && task.WantVirtualSource &&
    HasCoarseTriangles(
      context.Surface, graph.GetLinkAccuracy(), result.Distances, ErrorInsideTriangles))
  {
    TaskContext rest = context;
    rest.Progress = ProgressPart(progress, SearchedAt, 1.0);
    Status status = FindExactDistances(rest, ExactEngine::Triangle, true, task);
    if (status.IsOk())
    {
      FillArrays(result, task);
      result = SearchResult();
    }
    if (status.IsOk() || status.IsAborted())
    {
      return status;
    }
    task.QualityWarning = DescribeMissingWindows(
      context.Surface, graph.GetLinkAccuracy(), result.Distances, ErrorInsideTriangles, status);
  }
  if (task.WantVirtualSource)
  {
    FindVirtualSources(context.Surface.GetMesh(), result,
      isCorrected ? result.Corrected : result.Distances, task.VirtualSource, context.Parallel);
  }
  TakeResults(seeds, isCorrected, result, task);
  if (!task.IsSparse)
  {
    result = SearchResult();
  }
  return Status::Success();
}
}
