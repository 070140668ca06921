// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGThreads.h"

#include "dggRangeQueue.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <future>
#include <system_error>

//------------------------------------------------------------------------------
dgg::ParallelFor DGGMakeParallelFor(const dgg::ProgressCallback& progress)
{
  return [progress](dgg::Offset size, dgg::Offset grain,
           const std::function<void(dgg::Offset, dgg::Offset)>& body) {
    dgg::RangeQueue queue(size, grain, body);
    const dgg::Offset others = vtkSMPTools::IsParallelScope()
      ? 0
      : std::min<dgg::Offset>(
          vtkSMPTools::GetEstimatedNumberOfThreads(), queue.GetNumberOfRanges()) -
        1;
    std::future<void> done;
    if (others > 0)
    {
      // Not on this thread: with STDThread this thread would wait without taking ranges of the
      // loop, and with any backend it would wait until the last range is done.
      try
      {
        done = std::async(std::launch::async, [&queue, others] {
          vtkSMPTools::For(0, others, 1, [&queue](vtkIdType begin, vtkIdType end) {
            for (vtkIdType i = begin; i < end; ++i)
            {
              queue.RunOthers();
            }
          });
        });
      }
      catch (const std::system_error&)
      {
        // The system cannot create more threads: this thread runs all ranges.
      }
    }
    queue.RunFirst(progress);
    while (done.valid() && done.wait_for(dgg::PollInterval) != std::future_status::ready)
    {
      if (progress)
      {
        progress(0.0);
      }
    }
    if (done.valid())
    {
      done.get();
    }
    queue.Rethrow();
  };
}
