// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops on the threads of VTK. Internal.
#ifndef vtkDGGParallel_h
#define vtkDGGParallel_h

#include "dggParallel.h" // for ParallelFor

#include <atomic>     // for stopping
#include <cstddef>    // for std::size_t
#include <functional> // for the steps
#include <thread>     // for who may tell the progress

/// Runs loops by vtkSMPTools. What a loop throws in any thread is thrown to the caller, after the
/// loop: an exception that leaves a thread would end the program.
dgg::ParallelFor vtkDGGMakeParallelFor();

/// Do step(0) to step(count - 1), in any order and several at once, `block` of them between two
/// looks at the progress, which goes from 0 to 1. Stops at the first block with an error, and
/// returns the error of the step with the smallest number.
dgg::Status vtkDGGForBlocks(std::size_t count, std::size_t block,
  const dgg::ProgressCallback& progress, const std::function<dgg::Status(std::size_t)>& step);

/// Progress of steps that take long and run in several threads: only the thread that made it, and
/// waits for them, may tell it; the others learn whether to go on.
class vtkDGGSharedProgress
{
public:
  /// Of `count` steps. `progress` must outlive it.
  vtkDGGSharedProgress(const dgg::ProgressCallback& progress, std::size_t count);

  /// That of one step. Steps run in any order, so that it counts as if there were no other.
  dgg::ProgressCallback OfStep();
  /// That of the steps done, between them.
  bool Tell(double done);

private:
  const dgg::ProgressCallback& Progress;
  double Count;
  std::thread::id Teller;
  double Done = 0.0; // changes only while no step runs
  std::atomic<bool> IsStopped{ false };
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGParallel.h
