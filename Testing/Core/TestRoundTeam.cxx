// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Threads that share short loops: each chunk runs once, and exceptions are propagated.
#include "GraphChecks.h"

#include "dggRoundTeam.h"

#include <atomic>
#include <stdexcept>
#include <thread>

namespace dggtest
{
constexpr int most = dgg::RoundTeam::LargestTeam;

TEST(RoundTeam, EachChunkOnce)
{
  for (const int threads : { 0, 1, 2, 8, 40 })
  {
    const dgg::ParallelFor parallel = threads > 0 ? WithThreads(threads) : dgg::ParallelFor();
    std::vector<std::vector<int>> calls(most, std::vector<int>(37, 0));
    std::vector<std::vector<int>> expected = calls;
    std::vector<std::atomic<bool>> hasWorked(most);
    const auto lead = [&](dgg::RoundTeam& team) {
      for (int round = 0; round < 3000; ++round)
      {
        dgg::RoundTeam::Counts counts{};
        for (int t = 0; t < most; ++t)
        {
          counts[t] = t == 0 || hasWorked[t] ? (1 + round + t) % 37 : 0;
          for (dgg::Offset i = 0; i < counts[t]; ++i)
          {
            expected[t][i] += round;
          }
        }
        // One thread at a time handles a chunk; otherwise there is a race.
        team.ForEach(counts, team.IsShared(), [&, round](int owner, dgg::Offset i, int thread) {
          calls[owner][i] += round;
          hasWorked[thread] = true;
        });
      }
    };
    dgg::RoundTeam::Run(parallel, most, lead);
    EXPECT_EQ(calls, expected) << threads;
  }
}

TEST(RoundTeam, WhatIsThrownReachesTheCaller)
{
  for (const int threads : { 0, 1, 4 })
  {
    const dgg::ParallelFor parallel = threads > 0 ? WithThreads(threads) : dgg::ParallelFor();
    std::atomic<int> calls{ 0 };
    const auto lead = [&](dgg::RoundTeam& team) {
      const auto thrower = [&](int, dgg::Offset i, int) {
        ++calls;
        std::this_thread::yield();
        if (i % 3 == 1)
        {
          throw std::runtime_error("thrown");
        }
      };
      while (threads > 1 && !team.IsShared())
      {
        std::this_thread::yield();
      }
      EXPECT_THROW(team.ForEach({ { 50 } }, threads > 1, thrower), std::runtime_error);
      EXPECT_NO_THROW(team.ForEach({ { 50 } }, threads > 1, [](int, dgg::Offset, int) {}))
        << "thrown again";
      team.ForEach({ { 50 } }, threads > 1, thrower);
    };
    EXPECT_THROW(dgg::RoundTeam::Run(parallel, most, lead), std::runtime_error) << threads;
    EXPECT_GE(calls, 2);
  }
}
}
