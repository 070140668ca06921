// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Long steps in several threads: each is done once, and the progress does not wait for the last.
#include "vtkDGGParallel.h"

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
/// Calls `test` for all numbers of threads and ways to have them.
template <typename Test>
void ForEachBackend(Test&& test)
{
  const std::string original = vtkSMPTools::GetBackend();
  for (const char* backend : { "Sequential", "STDThread", "TBB" })
  {
    if (!vtkSMPTools::SetBackend(backend))
    {
      continue; // VTK was built without it
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

/// Waits until something is so, but not for ever.
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
      std::vector<std::atomic<int>> done(count);
      double last = 0.0;
      const dgg::Status status = vtkDGGForLongSteps(
        count,
        [&](double progress) {
          EXPECT_GE(progress, last);
          last = progress;
          return true;
        },
        [&](std::size_t step, const dgg::ProgressCallback& within) {
          ++done[step];
          return within(0.5) ? dgg::Status::Success() : dgg::Status::Abort();
        });
      EXPECT_TRUE(status.IsOk());
      EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](int times) { return times == 1; }));
      EXPECT_EQ(last, count > 0 ? 1.0 : 0.0);
    }
  });
}

TEST(LongSteps, TheFirstErrorCounts)
{
  ForEachBackend([] {
    const dgg::Status status = vtkDGGForLongSteps(
      50, [](double) { return true; },
      [](std::size_t step, const dgg::ProgressCallback&) {
        return step < 7 ? dgg::Status::Success()
                        : dgg::Status::Invalid("step " + std::to_string(step));
      });
    EXPECT_EQ(status.GetMessage(), "step 7");
    EXPECT_THROW(vtkDGGForLongSteps(
                   50, [](double) { return true; },
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

TEST(LongSteps, ProgressOfOthersIsToldWhileNothingIsLeftToDo)
{
  // The step of this thread is over soon, that of the other one goes on until it has been heard
  // of several times.
  ForEachBackend([] {
    if (vtkSMPTools::GetEstimatedNumberOfThreads() < 2)
    {
      return;
    }
    const auto caller = std::this_thread::get_id();
    std::atomic<int> heard{ 0 };
    std::atomic<int> begun{ 0 };
    const dgg::Status status = vtkDGGForLongSteps(
      2,
      [&](double) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        ++heard;
        return true;
      },
      [&](std::size_t, const dgg::ProgressCallback& within) {
        ++begun;
        EXPECT_TRUE(WaitUntil([&] { return begun == 2; })) << "one step after the other";
        if (std::this_thread::get_id() == caller)
        {
          return dgg::Status::Success();
        }
        const int before = heard;
        double done = 0.0;
        EXPECT_TRUE(WaitUntil([&] {
          done = std::min(1.0, done + 1e-4);
          within(done);
          return heard > before + 5;
        }));
        return dgg::Status::Success();
      });
    EXPECT_TRUE(status.IsOk());
  });
}

TEST(LongSteps, StopWhileOneIsLeft)
{
  ForEachBackend([] {
    if (vtkSMPTools::GetEstimatedNumberOfThreads() < 2)
    {
      return;
    }
    const auto caller = std::this_thread::get_id();
    std::atomic<bool> isAlone{ false };
    std::atomic<int> begun{ 0 };
    const dgg::Status status = vtkDGGForLongSteps(
      2, [&](double) { return !isAlone; },
      [&](std::size_t, const dgg::ProgressCallback& within) {
        ++begun;
        WaitUntil([&] { return begun == 2; });
        if (std::this_thread::get_id() == caller)
        {
          return dgg::Status::Success();
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        isAlone = true;
        return WaitUntil([&] { return !within(0.5); }) ? dgg::Status::Abort()
                                                       : dgg::Status::Success();
      });
    EXPECT_TRUE(status.IsAborted());
  });
}
