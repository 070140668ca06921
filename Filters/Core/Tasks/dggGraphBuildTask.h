// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Construction of a graph within the memory limit. Internal.
#ifndef dggGraphBuildTask_h
#define dggGraphBuildTask_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggGraphBuilder.h" // for GraphBuilder

#include <cstddef> // for std::size_t
#include <string>  // for messages

namespace dgg
{
class PreparedSurface;
struct Output;
struct TaskContext;

/// Sets the options that depend on the threads of the context.
DGG_CORE_EXPORT void UseThreads(const TaskContext& context, GraphOptions& options);

///@{
/// Return warnings about the graph of an input. The first states the problem because of which
/// another graph is built. The second is empty if the graph guarantees `accuracy`; `canAccept` is
/// true for filters with the property AcceptCoarserGraph.
DGG_CORE_EXPORT std::string DescribeReplacement(
  const std::string& problem, const GraphOptions& options);
DGG_CORE_EXPORT std::string DescribeAccuracy(
  const GraphInfo& graph, double accuracy, bool canAccept);
///@}

/// Returns the error for a cloud without a graph, which only its own filter builds.
DGG_CORE_EXPORT Status RequireCloudGraph(const std::string& problem);

/// Fails if a graph needs more bytes than the limit.
Status CheckGraphMemory(double limit, const GraphOptions& options, const GraphEstimate& estimate);

/// Builds a graph of the surface of `builder` if CheckGraphMemory() succeeds.
DGG_CORE_EXPORT Status BuildGraph(const TaskContext& context, const GraphBuilder& builder,
  GraphOptions options, GeodesicGraph& graph, GraphEstimate& estimate);

/// Returns an estimate of the bytes that a builder takes.
std::size_t EstimateBuilder(const PreparedSurface& surface);

/// Writes each edge once, as a line between two points of the surface, with the cell array `Length`
/// as scalars. Fails if the lines would exceed the memory limit.
DGG_CORE_EXPORT Status WriteGraphLines(const TaskContext& context, const GraphView& graph,
  const ProgressCallback& progress, Output& output);
}

#endif
