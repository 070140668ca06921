// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops on the threads of VTK. Internal.
#ifndef DGGThreads_h
#define DGGThreads_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggParallel.h"               // for ParallelFor

#include <cstddef>    // for std::size_t
#include <functional> // for the steps

/// Runs loops by vtkSMPTools. The calling thread takes part in them; between its ranges, and once
/// nothing is left for it to do, it calls `progress` with 0 now and then until the other threads
/// are done, so that what they have reported reaches the observers of a filter and their wish to
/// abort reaches the loop. What a loop throws in any thread is thrown to the caller, after the
/// loop: an exception that leaves a thread would end the program.
VTKDGGFILTERSCOMMON_EXPORT dgg::ParallelFor DGGMakeParallelFor(
  const dgg::ProgressCallback& progress = dgg::ProgressCallback());

/// Do step(0) to step(count - 1), several at once, by blocks of `grain`. A step that takes long may
/// report a progress of its own, from 0 to 1, where `grain` is 1. Returns the error of the step
/// with the smallest number.
VTKDGGFILTERSCOMMON_EXPORT dgg::Status DGGForEach(std::size_t count, std::size_t grain,
  const dgg::ProgressCallback& progress,
  const std::function<dgg::Status(std::size_t, const dgg::ProgressCallback&)>& step);

#endif
