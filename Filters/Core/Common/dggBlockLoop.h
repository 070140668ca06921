// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Long loops in blocks, of which the results stay in order. Internal.
#ifndef dggBlockLoop_h
#define dggBlockLoop_h

#include "dggParallel.h" // for ParallelFor

#include <algorithm> // for std::min
#include <mutex>     // for one call at a time
#include <vector>    // for what becomes of blocks

namespace dgg
{
/// Calls `step(worker, block, begin, end)` for all blocks of `size` elements, several at once, and
/// tells the progress from `start` to `stop` now and then. Blocks that are done in a row share what
/// `makeWorker` returns, so that its memory is used again; results must not depend on which these
/// are.
template <typename MakeWorker, typename Step>
Status LoopOverBlocks(Offset count, Offset size, const ParallelFor& parallel,
  const ProgressCallback& progress, double start, double stop, MakeWorker&& makeWorker, Step&& step)
{
  constexpr Offset BlocksAtOnce = 32; // between two looks at the progress
  const Offset blocks = (count + size - 1) / size;
  for (Offset first = 0; first < blocks; first += BlocksAtOnce)
  {
    const double done = static_cast<double>(first) / static_cast<double>(blocks);
    if (progress && !progress(start + (stop - start) * done))
    {
      return Status::Abort();
    }
    ForRange(parallel, std::min(BlocksAtOnce, blocks - first), 1, [&](Offset begin, Offset end) {
      auto worker = makeWorker();
      for (Offset b = first + begin; b < first + end; ++b)
      {
        step(worker, b, b * size, std::min(count, (b + 1) * size));
      }
    });
  }
  return progress && !progress(stop) ? Status::Abort() : Status::Success();
}

/// The same for a `step(block, begin, end)` that needs no worker.
template <typename Step>
Status LoopOverBlocks(Offset count, Offset size, const ParallelFor& parallel,
  const ProgressCallback& progress, double start, double stop, Step&& step)
{
  struct None
  {
  };
  return LoopOverBlocks(
    count, size, parallel, progress, start, stop, [] { return None(); },
    [&step](None&, Offset block, Offset begin, Offset end) { step(block, begin, end); });
}

/// One progress of blocks that run at once: the mean of theirs. It is told by the threads that run
/// them, one at a time.
class BlockProgress
{
public:
  BlockProgress(const ProgressCallback& progress, Offset blocks)
    : Progress(progress)
    , Blocks(static_cast<double>(blocks))
  {
  }

  /// False when all blocks are to stop. `told` is what this block has told before, at first 0.
  bool Tell(double done, double& told)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Sum += std::max(0.0, done - told);
    told = std::max(told, done);
    if (!this->IsStopped && this->Progress)
    {
      this->IsStopped = !this->Progress(std::min(1.0, this->Sum / this->Blocks));
    }
    return !this->IsStopped;
  }
  /// Only after the loop.
  bool HasStopped() const { return this->IsStopped; }

private:
  const ProgressCallback& Progress;
  double Blocks;
  std::mutex Mutex;
  double Sum = 0.0;
  bool IsStopped = false;
};

/// As LoopOverBlocks(), for blocks that may take long, so that the progress is looked at before and
/// within each: calls `step(worker, block, begin, end, progress)` for all blocks of `size`
/// elements. What a step returns must not depend on the worker, which others have used before.
/// Returns the error of the first block that has one. `progress` goes from 0 to 1; the threads of
/// `parallel` call it, one at a time, so it must not care which.
template <typename MakeWorker, typename Step>
Status LoopOverLongBlocks(Offset count, Offset size, const ParallelFor& parallel,
  const ProgressCallback& progress, MakeWorker&& makeWorker, Step&& step)
{
  const Offset blocks = (count + size - 1) / size;
  std::vector<Status> found(static_cast<std::size_t>(blocks));
  BlockProgress shared(progress, blocks);
  ForRange(parallel, blocks, 1, [&](Offset first, Offset last) {
    auto worker = makeWorker();
    for (Offset b = first; b < last; ++b)
    {
      double told = 0.0;
      const ProgressCallback within = [&](double done) { return shared.Tell(done, told); };
      found[b] = within(0.0) ? step(worker, b, b * size, std::min(count, (b + 1) * size), within)
                             : Status::Abort();
      if (!found[b].IsOk() || !within(1.0))
      {
        return;
      }
    }
  });
  if (shared.HasStopped())
  {
    return Status::Abort();
  }
  const auto failed =
    std::find_if(found.begin(), found.end(), [](const Status& status) { return !status.IsOk(); });
  if (failed != found.end())
  {
    return *failed;
  }
  return progress && !progress(1.0) ? Status::Abort() : Status::Success();
}

/// The same for a `step(block, begin, end, progress)` that needs no worker.
template <typename Step>
Status LoopOverLongBlocks(Offset count, Offset size, const ParallelFor& parallel,
  const ProgressCallback& progress, Step&& step)
{
  struct None
  {
  };
  return LoopOverLongBlocks(
    count, size, parallel, progress, [] { return None(); },
    [&step](None&, Offset block, Offset begin, Offset end, const ProgressCallback& within) {
      return step(block, begin, end, within);
    });
}
}

#endif
