// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surface, memory, threads and progress of a task. Internal.
#ifndef dggTaskContext_h
#define dggTaskContext_h

#include "dggMemoryLimit.h" // for MemoryBudget
#include "dggParallel.h"    // for ParallelFor
#include "dggTypes.h"       // for ProgressCallback

#include <functional> // for the cells

namespace dgg
{
class PreparedSurface;
class ProcessGroup;
struct SurfaceArrays;

/// Made once at the start of an update and passed to all of its steps, which do not change it.
struct TaskContext
{
  const PreparedSurface& Surface;
  MemoryBudget Memory;
  int NumberOfThreads = 1;   ///< threads of Parallel
  ProgressCallback Progress; ///< callable from any thread; returns false to abort
  ParallelFor Parallel;
  /// Returns the polygons and strips of the input, without its points. They are converted at the
  /// first call.
  std::function<const SurfaceArrays&()> GetCells;
  /// Processes that help the first one, which has the surface; null if there are none. The first
  /// process calls DismissHelpers() after the task, the others call HelpFirstProcess() instead of
  /// the task.
  ProcessGroup* Group = nullptr;
};
}

#endif
