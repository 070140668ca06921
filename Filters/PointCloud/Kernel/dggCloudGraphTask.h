// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graphs of prepared clouds, with warnings. Internal.
#ifndef dggCloudGraphTask_h
#define dggCloudGraphTask_h

#include "dggCloudGraphBuilder.h" // for options and results

#include <string> // for warnings
#include <vector> // for warnings

namespace dgg
{
struct TaskContext;

///@{
/// Predicts the size of a graph of the cloud, or builds the graph, with the signature of the cloud.
/// Memory limit and threads of the options are those of the context. Fails for a surface.
Status EstimateCloudGraph(const TaskContext& context, CloudGraphOptions options,
  const ProgressCallback& progress, CloudGraphEstimate& estimate);
Status BuildCloudGraph(const TaskContext& context, CloudGraphOptions options,
  const ProgressCallback& progress, CloudGraph& graph, CloudGraphStatistics& statistics);
///@}

/// Returns warnings about the points of a graph, and about voxels that are coarser than the points.
std::vector<std::string> DescribeCloudGraph(
  const CloudGraphOptions& options, const CloudGraphStatistics& statistics);
}

#endif
