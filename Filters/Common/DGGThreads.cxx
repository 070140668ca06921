// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGThreads.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <mutex>
#include <system_error>

namespace
{
/// Interval at which the calling thread reports progress, between its ranges and while it waits for
/// other threads.
constexpr std::chrono::milliseconds PollInterval(10);

/// Ranges of a loop. Threads take ranges in succession until none is left or one throws. The range
/// at 0 is reserved for the calling thread.
class RangeQueue
{
public:
  RangeQueue(
    dgg::Offset size, dgg::Offset grain, const std::function<void(dgg::Offset, dgg::Offset)>& body)
    : Size(size)
    , Grain(std::max<dgg::Offset>(1, grain))
    , Body(body)
    , Next(this->Grain)
  {
  }

  void RunFirst(const dgg::ProgressCallback& progress) noexcept { this->Run(0, progress); }
  void RunOthers() noexcept { this->Run(this->Next.fetch_add(this->Grain), nullptr); }
  void Rethrow() const
  {
    if (this->Thrown)
    {
      std::rethrow_exception(this->Thrown);
    }
  }
  dgg::Offset GetNumberOfRanges() const { return (this->Size + this->Grain - 1) / this->Grain; }

private:
  void Run(dgg::Offset begin, const dgg::ProgressCallback& progress) noexcept
  {
    try
    {
      auto due = std::chrono::steady_clock::now() + PollInterval;
      for (; begin < this->Size; begin = this->Next.fetch_add(this->Grain))
      {
        this->Body(begin, std::min(this->Size, begin + this->Grain));
        if (progress && std::chrono::steady_clock::now() > due)
        {
          progress(0.0);
          due = std::chrono::steady_clock::now() + PollInterval;
        }
      }
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Thrown = this->Thrown ? this->Thrown : std::current_exception();
      this->Next = this->Size;
    }
  }

  const dgg::Offset Size;
  const dgg::Offset Grain;
  const std::function<void(dgg::Offset, dgg::Offset)>& Body;
  std::atomic<dgg::Offset> Next;
  std::mutex Mutex;
  std::exception_ptr Thrown;
};
}

//------------------------------------------------------------------------------
dgg::ParallelFor DGGMakeParallelFor(const dgg::ProgressCallback& progress)
{
  return [progress](dgg::Offset size, dgg::Offset grain,
           const std::function<void(dgg::Offset, dgg::Offset)>& body) {
    RangeQueue queue(size, grain, body);
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
    while (done.valid() && done.wait_for(PollInterval) != std::future_status::ready)
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
