// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a task works with. Internal.
#ifndef dggTaskContext_h
#define dggTaskContext_h

#include "dggMemoryLimit.h" // for MemoryBudget
#include "dggParallel.h"    // for ParallelFor
#include "dggTypes.h"       // for ProgressCallback

namespace dgg
{
class PreparedSurface;

/// Made once at the start of an update and passed to all of its steps. It does not change.
struct TaskContext
{
  const PreparedSurface& Surface;
  MemoryBudget Memory;
  int NumberOfThreads = 1;   ///< that Parallel runs on
  ProgressCallback Progress; ///< may be called from any thread; false: stop
  ParallelFor Parallel;
};
}

#endif
