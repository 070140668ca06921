// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Steps in several threads: each step runs once, and progress is reported while the last step
/// runs.
#include "DGGThreads.h"

#include "dggBlockLoop.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace
{
/// Calls `test` for several numbers of threads and all backends of vtkSMPTools.
template <typename Test>
void ForEachBackend(Test&& test)
{
  const std::string original = vtkSMPTools::GetBackend();
  for (const char* backend : { "Sequential", "STDThread", "TBB" })
  {
    if (!vtkSMPTools::SetBackend(backend))
    {
      continue; // not available in this build of VTK
    }
    for (const int threads : { 1, 2, 3 })
    {
      vtkSMPTools::Initialize(threads);
      SCOPED_TRACE(std::string(backend) + " " + std::to_string(threads));
      test();
    }
  }
  vtkSMPTools::Initialize();
  vtkSMPTools::SetBackend(original.c_str());
}

/// Waits until a condition holds, at most 5 s. Returns the condition.
template <typename Condition>
bool WaitUntil(Condition&& condition)
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (!condition() && std::chrono::steady_clock::now() < end)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}
}

TEST(LongSteps, EachIsDoneOnce)
{
  ForEachBackend([] {
    for (const std::size_t count : { 0, 1, 2, 7, 100 })
    {
      for (const std::size_t grain : { 1, 3 })
      {
        std::vector<std::atomic<int>> done(count);
        std::atomic<double> most{ 0.0 };
        const dgg::ProgressCallback progress = [&](double value) {
          double before = most;
          while (before < value && !most.compare_exchange_weak(before, value))
          {
          }
          return true;
        };
        const dgg::Status status = dgg::ForEach(count, grain, DGGMakeParallelFor(progress),
          progress, [&](std::size_t step, const dgg::ProgressCallback& within) {
            ++done[step];
            return within(0.5) ? dgg::Status::Success() : dgg::Status::Abort();
          });
        EXPECT_TRUE(status.IsOk());
        EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](int times) { return times == 1; }));
        EXPECT_EQ(most, 1.0);
      }
    }
  });
}

TEST(LongSteps, TheFirstErrorCounts)
{
  ForEachBackend([] {
    const dgg::ProgressCallback goOn = [](double) { return true; };
    const dgg::Status status = dgg::ForEach(
      50, 1, DGGMakeParallelFor(goOn), goOn, [](std::size_t step, const dgg::ProgressCallback&) {
        return step < 7 ? dgg::Status::Success() : dgg::InvalidInput("step ", step);
      });
    EXPECT_EQ(status.GetProblem(), "step 7");
    EXPECT_THROW(dgg::ForEach(50, 1, DGGMakeParallelFor(goOn), goOn,
                   [](std::size_t step, const dgg::ProgressCallback&) -> dgg::Status {
                     if (step == 9)
                     {
                       throw std::runtime_error("step 9");
                     }
                     return dgg::Status::Success();
                   }),
      std::runtime_error);
  });
}

// The step of this thread is short. The step of another thread runs until this thread has reported
// progress several times, and then stops as if aborted by an observer.
TEST(LongSteps, ProgressWhileNothingIsLeftToDo)
{
  ForEachBackend([] {
    if (vtkSMPTools::GetEstimatedNumberOfThreads() < 2)
    {
      return;
    }
    const auto caller = std::this_thread::get_id();
    std::atomic<int> calls{ 0 };
    std::atomic<int> begun{ 0 };
    std::atomic<bool> isStopped{ false };
    const dgg::ProgressCallback progress = [&](double) {
      isStopped = isStopped || (std::this_thread::get_id() == caller && ++calls > 10);
      return !isStopped;
    };
    const dgg::Status status = dgg::ForEach(2, 1, DGGMakeParallelFor(progress), progress,
      [&](std::size_t, const dgg::ProgressCallback& within) {
        ++begun;
        EXPECT_TRUE(WaitUntil([&] { return begun == 2; })) << "one step after the other";
        if (std::this_thread::get_id() == caller)
        {
          return dgg::Status::Success();
        }
        return WaitUntil([&] { return !within(0.5); }) ? dgg::Status::Abort()
                                                       : dgg::Status::Success();
      });
    EXPECT_TRUE(status.IsAborted());
  });
}
