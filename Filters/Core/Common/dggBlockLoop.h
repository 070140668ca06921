// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Long loops in blocks, of which the results stay in order. Internal.
#ifndef dggBlockLoop_h
#define dggBlockLoop_h

#include "dggParallel.h" // for ParallelFor

#include <algorithm> // for std::min

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
}

#endif
