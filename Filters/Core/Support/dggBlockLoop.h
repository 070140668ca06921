// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Long loops in blocks that run simultaneously, with one progress. Internal.
#ifndef dggBlockLoop_h
#define dggBlockLoop_h

#include "dggParallel.h"     // for ParallelFor
#include "dggProgressPart.h" // for ShouldContinue()

#include <algorithm>   // for std::min
#include <atomic>      // for what blocks share
#include <type_traits> // for the kind of step
#include <vector>      // for the outcomes of blocks

namespace dgg
{
/// Combines the progress of blocks that run simultaneously: the mean of their progress values.
class SharedProgress
{
public:
  SharedProgress(const ProgressCallback& progress, Offset blocks)
    : Progress(progress)
    , Blocks(static_cast<double>(blocks))
  {
  }

  /// Reports the completed fraction `done` of a block. Returns false if all blocks must stop.
  /// `reported` is the fraction that the block has reported so far, initially 0; it is updated.
  bool Report(double done, double& reported)
  {
    double sum = this->Sum;
    const double more = std::max(0.0, done - reported);
    reported = std::max(reported, done);
    while (!this->Sum.compare_exchange_weak(sum, sum + more))
    {
    }
    if (!this->IsStopped &&
      !ShouldContinue(this->Progress, std::min(1.0, (sum + more) / this->Blocks)))
    {
      this->IsStopped = true;
    }
    return !this->IsStopped;
  }
  bool HasStopped() const { return this->IsStopped; }

private:
  const ProgressCallback& Progress;
  double Blocks;
  std::atomic<double> Sum{ 0.0 };
  std::atomic<bool> IsStopped{ false };
};

/// Calls `step(worker, block, begin, end, progress)` for all blocks of `size` elements, several of
/// them simultaneously. A step returns a Status; short steps may omit the progress argument and
/// return nothing. Each thread makes one worker by `makeWorker` and reuses it for all of its
/// blocks; results must not depend on which blocks these are. Returns the error of the first block
/// that fails. `progress` runs from 0 to 1.
template <typename MakeWorker, typename Step>
Status ForBlocks(Offset count, Offset size, const ParallelFor& parallel,
  const ProgressCallback& progress, MakeWorker&& makeWorker, Step&& step)
{
  const Offset blocks = (count + size - 1) / size;
  std::vector<Status> outcomes(static_cast<std::size_t>(blocks));
  std::atomic<Offset> failed{ blocks }; // the first block that is known to have an error
  SharedProgress shared(progress, blocks);
  // Each thread takes one block after the other, regardless of its range, with a single worker.
  std::atomic<Offset> next{ 0 };
  ForRange(parallel, blocks, 1, [&](Offset, Offset) {
    Offset b = next++;
    if (b >= blocks)
    {
      return;
    }
    auto worker = makeWorker();
    const auto run = [&](Offset b, const ProgressCallback& within) {
      const Offset end = std::min(count, (b + 1) * size);
      if constexpr (std::is_invocable_v<Step&, decltype(worker)&, Offset, Offset, Offset,
                      const ProgressCallback&>)
      {
        return step(worker, b, b * size, end, within);
      }
      else
      {
        step(worker, b, b * size, end);
        return Status::Success();
      }
    };
    for (; b < blocks && b < failed; b = next++)
    {
      double reported = 0.0;
      const ProgressCallback within = [&](double done) { return shared.Report(done, reported); };
      outcomes[b] = within(0.0) ? run(b, within) : Status::Abort();
      if (!outcomes[b].IsOk() || !within(1.0))
      {
        for (Offset known = failed; b < known && !failed.compare_exchange_weak(known, b);)
        {
        }
        return;
      }
    }
  });
  if (shared.HasStopped())
  {
    return Status::Abort();
  }
  if (failed < blocks)
  {
    return outcomes[failed];
  }
  return progress && !progress(1.0) ? Status::Abort() : Status::Success();
}

/// Runs ForBlocks() with a step that needs no worker.
template <typename Step>
Status ForBlocks(Offset count, Offset size, const ParallelFor& parallel,
  const ProgressCallback& progress, Step&& step)
{
  struct None
  {
  };
  return ForBlocks(
    count, size, parallel, progress, [] { return None(); },
    [&step](None&, Offset block, Offset begin, Offset end, const ProgressCallback& within) {
      return step(block, begin, end, within);
    });
}

/// Calls step(i, progress) for i in [0, count), in blocks of `grain`. The progress of a step, from
/// 0 to 1, is only meaningful if `grain` is 1. Returns the error with the smallest i.
template <typename Step>
Status ForEach(std::size_t count, std::size_t grain, const ParallelFor& parallel,
  const ProgressCallback& progress, Step&& step)
{
  return ForBlocks(static_cast<Offset>(count), static_cast<Offset>(grain), parallel, progress,
    [&step](Offset, Offset begin, Offset end, const ProgressCallback& within) {
      Status status;
      for (Offset i = begin; i < end && status.IsOk(); ++i)
      {
        status = step(static_cast<std::size_t>(i), within);
      }
      return status;
    });
}
}

#endif
