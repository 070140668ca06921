// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Parallel loops on the threads of VTK. Internal.
#ifndef DGGThreads_h
#define DGGThreads_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggParallel.h"               // for ParallelFor
#include "dggTypes.h"                  // for ProgressCallback

/// Returns a function that runs loops by vtkSMPTools. The calling thread takes ranges as well.
/// Between its ranges, and while it waits for the other threads, it regularly calls `progress` with
/// 0. Thus progress that other threads have reported reaches the observers of a filter, and a
/// request to abort reaches the loop. An exception of any thread is rethrown to the caller after
/// the loop, because an exception that leaves a thread would end the program.
VTKDGGFILTERSCOMMON_EXPORT dgg::ParallelFor DGGMakeParallelFor(
  const dgg::ProgressCallback& progress = dgg::ProgressCallback());

#endif
