// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudGraphTask.h"

#include "dggCounted.h"
#include "dggPreparedSurface.h"
#include "dggStatus.h"
#include "dggTaskContext.h"

namespace dgg
{
namespace
{
/// Largest ratio of noise to radius of curvature without a warning: distances on spheres are then 1
/// % too short.
constexpr double LargestNoiseByRadius = 0.07;

/// Sets the options that depend on the context.
Status UseContext(
  const TaskContext& context, const ProgressCallback& progress, CloudGraphOptions& options)
{
  options.MemoryLimit = static_cast<std::size_t>(context.Memory.GetBytes());
  options.Parallel = context.Parallel;
  options.NumberOfThreads = context.NumberOfThreads;
  options.Progress = progress;
  return context.Surface.IsCloud() ? Status::Success()
                                   : InvalidInput("The surface is not a point cloud")
                                       .At("Surface")
                                       .Fix("Make the surface with {Cloud}");
}

CloudGraphBuilder MakeBuilder(const PreparedSurface& cloud)
{
  return { cloud.GetPositions(), cloud.GetMeshWithoutAngles().GetNumberOfVertices() };
}

/// Returns a warning about noise; empty if there is little.
std::string DescribeNoise(const CloudGraphStatistics& statistics)
{
  if (statistics.Scatter > 0.0)
  {
    return JoinText("The neighbors of ", 100.0 * statistics.OffSurface,
      " % of the points do not lie on a surface: points typically scatter by ", statistics.Scatter,
      " times their spacing. Such noise is removed in part only, so distances may be far off. Thin "
      "the cloud, for example to every tenth point or to averages of points, until points scatter "
      "by less than their spacing");
  }
  return statistics.NoiseByRadius > LargestNoiseByRadius
    ? JoinText("The noise of the points, ", statistics.Noise, ", is ", statistics.NoiseByRadius,
        " of the typical radius of curvature. After its removal distances may be off by 1 % or "
        "more, mostly too short. Use points with less noise if that matters")
    : std::string();
}

/// Returns a warning about voxels; empty if they are finer than the points.
std::string DescribeVoxels(const CloudGraphOptions& options, const CloudGraphStatistics& used)
{
  if (!(used.Spacing > 0.0 && used.VoxelSize > used.Spacing))
  {
    return {};
  }
  const bool isGiven = options.OffsetInVoxels > 0.0;
  return JoinText("The voxels of the band, of size ", used.VoxelSize, " ({Resolution} ",
    used.Resolution, options.Resolution > 0 ? "" : ", automatic",
    "), are larger than the spacing of the points, which is ", used.Spacing, ". ",
    isGiven ? "The graph bridges gaps and holes, and may connect separate or split connected parts"
            : "Building is slower",
    ". ",
    options.Resolution > 0 || isGiven
      ? "Use a larger {Resolution}"
      : "Parts of the cloud are much sparser than others. Exclude these parts, or build separate "
        "graphs, if that matters");
}
}

Status EstimateCloudGraph(const TaskContext& context, CloudGraphOptions options,
  const ProgressCallback& progress, CloudGraphEstimate& estimate)
{
  DGG_RETURN_IF_ERROR(UseContext(context, progress, options));
  return MakeBuilder(context.Surface).Estimate(options, estimate);
}

Status BuildCloudGraph(const TaskContext& context, CloudGraphOptions options,
  const ProgressCallback& progress, CloudGraph& graph, CloudGraphStatistics& statistics)
{
  DGG_RETURN_IF_ERROR(UseContext(context, progress, options));
  DGG_RETURN_IF_ERROR(MakeBuilder(context.Surface).Build(options, graph, &statistics));
  graph.Graph.Info.Surface = context.Surface.GetSignature();
  return Status::Success();
}

std::vector<std::string> DescribeCloudGraph(
  const CloudGraphOptions& options, const CloudGraphStatistics& statistics)
{
  std::vector<std::string> warnings;
  if (statistics.UnusedPoints > 0)
  {
    warnings.push_back(JoinText("The cloud has ", Counted(statistics.UnusedPoints, "point"),
      " with a coordinate that is not finite. Such points have no edges in the graph"));
  }
  if (statistics.Outliers > 0)
  {
    warnings.push_back(JoinText("The cloud has ", Counted(statistics.Outliers, "point"),
      " more than 1000 times as far away as all others. The graph connects such points only to "
      "points at the same position"));
  }
  for (const std::string& warning :
    { DescribeNoise(statistics), DescribeVoxels(options, statistics) })
  {
    if (!warning.empty())
    {
      warnings.push_back(warning);
    }
  }
  return warnings;
}
}
