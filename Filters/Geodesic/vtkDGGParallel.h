// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops on the threads of VTK. Internal.
#ifndef vtkDGGParallel_h
#define vtkDGGParallel_h

#include "dggParallel.h" // for ParallelFor

#include <cstddef>    // for std::size_t
#include <functional> // for the steps

/// Runs loops by vtkSMPTools. What a loop throws in any thread is thrown to the caller, after the
/// loop: an exception that leaves a thread would end the program.
dgg::ParallelFor vtkDGGMakeParallelFor();

/// Do step(0) to step(count - 1), in any order and several at once: blocks of at least `block` of
/// them, and of several for each thread, between two looks at the progress, which goes from 0 to 1.
/// Returns the error of the step with the smallest number. After an error no later step starts;
/// steps before it do, as one of them may fail as well. A single step runs in the calling thread.
dgg::Status vtkDGGForBlocks(std::size_t count, std::size_t block,
  const dgg::ProgressCallback& progress, const std::function<dgg::Status(std::size_t)>& step);

/// The same for steps that take long, and tell a progress of their own: that of all is the mean of
/// theirs. Only the calling thread reports it; the others learn whether to go on.
dgg::Status vtkDGGForLongSteps(std::size_t count, const dgg::ProgressCallback& progress,
  const std::function<dgg::Status(std::size_t, const dgg::ProgressCallback&)>& step);

/// Run work whose `progress` other threads may tell, one at a time: it is passed on by the calling
/// thread alone, also where that waits while others do the work.
dgg::Status vtkDGGRunTold(const dgg::ProgressCallback& progress,
  const std::function<dgg::Status(const dgg::ProgressCallback&)>& work);

#endif
// VTK-HeaderTest-Exclude: vtkDGGParallel.h
