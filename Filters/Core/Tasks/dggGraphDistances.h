// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances along a graph. Internal.
#ifndef dggGraphDistances_h
#define dggGraphDistances_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggGraphSearch.h" // for SearchMethod

namespace dgg
{
class GraphSession;
struct DistanceTask;
struct TaskContext;

/// Computes the distances of a task, corrected if requested and not on a cloud. `graph` must be up
/// to date. All arrays of the task receive the lengths of paths, which are upper bounds.
DGG_CORE_EXPORT Status FindGraphDistances(const TaskContext& context, GraphSession& graph,
  SearchMethod method, bool correct, DistanceTask& task);
}

#endif
