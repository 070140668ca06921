// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Threads that share short loops: each chunk once, and what is thrown arrives.
#include "GraphChecks.h"

#include "dggRoundTeam.h"

#include <atomic>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace dggtest
{
TEST(RoundTeam, EachChunkOnce)
{
  for (const int threads : { 0, 1, 2, 8 })
  {
    const dgg::ParallelFor parallel = threads > 0 ? WithThreads(threads) : dgg::ParallelFor();
    std::vector<int> calls(37, 0); // of one thread at a time, else a race
    const auto lead = [&](dgg::RoundTeam& team) {
      for (int round = 0; round < 3000; ++round)
      {
        const dgg::Offset count = 1 + round % 37;
        team.ForEach(count, team.IsShared(), [&, round](dgg::Offset i) { calls[i] += round; });
      }
    };
    dgg::RoundTeam::Run(parallel, lead);
    std::vector<int> expected(37, 0);
    for (int round = 0; round < 3000; ++round)
    {
      for (int i = 0; i <= round % 37; ++i)
      {
        expected[i] += round;
      }
    }
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
      const auto thrower = [&](dgg::Offset i) {
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
      EXPECT_THROW(team.ForEach(50, threads > 1, thrower), std::runtime_error);
      EXPECT_NO_THROW(team.ForEach(50, threads > 1, [](dgg::Offset) {})) << "thrown again";
      team.ForEach(50, threads > 1, thrower);
    };
    EXPECT_THROW(dgg::RoundTeam::Run(parallel, lead), std::runtime_error) << threads;
    EXPECT_GE(calls, 2);
  }
}
}
