// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadPool.h"

#include "dggRangeQueue.h"

#include <pybind11/pybind11.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>

namespace dggPython
{
namespace
{
constexpr int LargestNumberOfThreads = 1024;

/// True while the thread runs ranges of a loop.
thread_local bool IsInLoop = false;

std::atomic<int> DefaultNumberOfThreads{ 0 }; // 0 for the number of processors

/// Marks the thread as running ranges of a loop.
struct LoopScope
{
  const bool WasInLoop = IsInLoop;

  LoopScope() { IsInLoop = true; }
  ~LoopScope() { IsInLoop = this->WasInLoop; }
  LoopScope(const LoopScope&) = delete;
  LoopScope& operator=(const LoopScope&) = delete;
};

struct Loop
{
  dgg::RangeQueue Ranges;
  int NumberOfHelpers = 0; ///< threads of the pool in this loop; guarded by the pool
};

/// Threads that wait for loops. The pool and its threads exist until the process ends.
class ThreadPool
{
public:
  /// Lets up to `helpers` threads take ranges of the loop.
  void Start(Loop& loop, dgg::Offset helpers)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Requests.insert(this->Requests.end(), static_cast<std::size_t>(helpers), &loop);
    try
    {
      for (; this->NumberOfThreads < helpers; ++this->NumberOfThreads)
      {
        std::thread([this] { this->Work(); }).detach();
      }
    }
    catch (const std::system_error&)
    {
      // The system cannot create more threads: the calling thread runs what is left.
    }
    this->Requested.notify_all();
  }

  /// Waits until no other thread runs a range of the loop.
  void Finish(Loop& loop, const dgg::ProgressCallback& progress)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Requests.erase(
      std::remove(this->Requests.begin(), this->Requests.end(), &loop), this->Requests.end());
    while (loop.NumberOfHelpers > 0)
    {
      this->Left.wait_for(lock, dgg::PollInterval);
      if (progress && loop.NumberOfHelpers > 0)
      {
        lock.unlock();
        progress(0.0);
        lock.lock();
      }
    }
  }

private:
  void Work()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    for (;;)
    {
      while (this->Requests.empty())
      {
        // Waiting without a limit would need the libstdc++ of GCC 12.
        this->Requested.wait_for(lock, std::chrono::hours(1));
      }
      Loop& loop = *this->Requests.front();
      this->Requests.pop_front();
      ++loop.NumberOfHelpers;
      lock.unlock();
      {
        const LoopScope scope;
        loop.Ranges.RunOthers();
      }
      lock.lock();
      --loop.NumberOfHelpers;
      this->Left.notify_all();
    }
  }

  std::mutex Mutex;
  std::condition_variable Requested;
  std::condition_variable Left;
  std::deque<Loop*> Requests; // one per thread that may help
  dgg::Offset NumberOfThreads = 0;
};

ThreadPool* TheThreadPool = new ThreadPool;
}

//------------------------------------------------------------------------------
void CheckNumberOfThreads(int count)
{
  if (count < 1 || count > LargestNumberOfThreads)
  {
    throw pybind11::value_error("number_of_threads: expected an integer from 1 to " +
      std::to_string(LargestNumberOfThreads) + ", got " + std::to_string(count));
  }
}

//------------------------------------------------------------------------------
void SetDefaultNumberOfThreads(int count)
{
  CheckNumberOfThreads(count);
  DefaultNumberOfThreads = count;
}

//------------------------------------------------------------------------------
int GetDefaultNumberOfThreads()
{
  const int count = DefaultNumberOfThreads;
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  return count > 0 ? count : std::min(std::max(1, processors), LargestNumberOfThreads);
}

//------------------------------------------------------------------------------
void ReplaceThreadPool()
{
  TheThreadPool = new ThreadPool; // the other one may be locked for ever
}

//------------------------------------------------------------------------------
dgg::ParallelFor MakeParallelFor(int numberOfThreads, const dgg::ProgressCallback& progress)
{
  return [numberOfThreads, progress](
           dgg::Offset size, dgg::Offset grain, const dgg::RangeQueue::LoopBody& body) {
    Loop loop{ { size, grain, body } };
    const dgg::Offset helpers =
      IsInLoop ? 0 : std::min<dgg::Offset>(numberOfThreads, loop.Ranges.GetNumberOfRanges()) - 1;
    if (helpers > 0)
    {
      TheThreadPool->Start(loop, helpers);
    }
    {
      const LoopScope scope;
      loop.Ranges.RunFirst(progress);
    }
    if (helpers > 0)
    {
      TheThreadPool->Finish(loop, progress);
    }
    loop.Ranges.Rethrow();
  };
}
}
