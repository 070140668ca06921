// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Ranges of a loop that several threads share. Internal.
#ifndef dggRangeQueue_h
#define dggRangeQueue_h

#include "dggTypes.h" // for Offset

#include <algorithm>  // for std::min
#include <atomic>     // for the next range
#include <chrono>     // for the progress
#include <exception>  // for exceptions of the body
#include <functional> // for the body
#include <mutex>      // for exceptions of the body

namespace dgg
{
/// Interval at which the calling thread reports progress, between its ranges and while it waits for
/// other threads.
inline constexpr std::chrono::milliseconds PollInterval(10);

/// Ranges of a loop. Threads take ranges in succession until none is left or one throws. The range
/// at 0 is reserved for the calling thread.
class RangeQueue
{
public:
  using LoopBody = std::function<void(Offset, Offset)>;

  RangeQueue(Offset size, Offset grain, const LoopBody& body)
    : Size(size)
    , Grain(std::max<Offset>(1, grain))
    , Body(body)
    , Next(this->Grain)
  {
  }

  void RunFirst(const ProgressCallback& progress) noexcept { this->Run(0, progress); }
  void RunOthers() noexcept { this->Run(this->Next.fetch_add(this->Grain), nullptr); }
  void Rethrow() const
  {
    if (this->Thrown)
    {
      std::rethrow_exception(this->Thrown);
    }
  }
  Offset GetNumberOfRanges() const { return (this->Size + this->Grain - 1) / this->Grain; }

private:
  void Run(Offset begin, const ProgressCallback& progress) noexcept
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

  const Offset Size;
  const Offset Grain;
  const LoopBody& Body;
  std::atomic<Offset> Next;
  std::mutex Mutex;
  std::exception_ptr Thrown;
};
}

#endif
