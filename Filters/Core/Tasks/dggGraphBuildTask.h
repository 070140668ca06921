// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Construction of a graph within the memory limit. Internal.
#ifndef dggGraphBuildTask_h
#define dggGraphBuildTask_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggGraphBuilder.h" // for GraphBuilder

#include <cstddef> // for std::size_t

namespace dgg
{
class PreparedSurface;
struct TaskContext;

/// Sets the options that depend on the threads of the context.
DGG_CORE_EXPORT void UseThreads(const TaskContext& context, GraphOptions& options);

/// Builds a graph of the surface, which is that of `builder`. Fails before it starts if the graph
/// would take more memory than the limit. `estimate` is the predicted memory.
DGG_CORE_EXPORT Status BuildGraph(const TaskContext& context, const GraphBuilder& builder,
  GraphOptions options, GeodesicGraph& graph, GraphEstimate& estimate);

/// Returns an estimate of the bytes that a builder takes.
std::size_t EstimateBuilder(const PreparedSurface& surface);
}

#endif
