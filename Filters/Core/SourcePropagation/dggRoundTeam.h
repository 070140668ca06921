// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Threads that share many short loops, one after the other. Internal.
#ifndef dggRoundTeam_h
#define dggRoundTeam_h

#include "dggParallel.h" // for ParallelFor

#include <atomic>     // for what threads share
#include <chrono>     // for the patience
#include <exception>  // for what chunks throw
#include <functional> // for the loops
#include <mutex>      // for the first exception
#include <thread>     // for std::this_thread::yield
#include <utility>    // for std::exchange

namespace dgg
{
/// A loop over thousands of short rounds, each of which is parallel: to start threads for each
/// round would take longer than the rounds. So threads are started once; one leads, and the others
/// wait actively for chunks of the round that it is at. No thread waits for one that has not taken
/// a chunk, so that any scheduler will do, one without threads included.
class RoundTeam
{
public:
  /// Calls lead(team) in one of the threads of the loop. What it throws reaches the caller.
  template <typename Lead>
  static void Run(const ParallelFor& parallel, Lead&& lead)
  {
    RoundTeam team;
    if (!parallel)
    {
      lead(team);
      return;
    }
    std::exception_ptr thrown;
    // The thread that calls leads, if it takes part in the loop: observers hear from it only.
    const std::thread::id caller = std::this_thread::get_id();
    ForRange(parallel, LargestTeam, 1, [&](Offset, Offset) {
      if (std::this_thread::get_id() != caller)
      {
        team.Follow();
      }
      if (team.IsLed.exchange(true))
      {
        team.Follow();
        return;
      }
      try
      {
        lead(team);
      }
      catch (...)
      {
        // The leader may be in a thread of the scheduler, which would end the program.
        thrown = std::current_exception();
      }
      team.IsOver.store(true, std::memory_order_release);
    });
    if (thrown)
    {
      std::rethrow_exception(thrown);
    }
  }

  /// Whether others have come to help. Asked once a round: it decides whether the steps of a round
  /// need protection from each other.
  bool IsShared() const { return this->Followers.load(std::memory_order_acquire) > 0; }

  /// Calls chunk(0) to chunk(count - 1), several at once if the round is shared. Only for the
  /// leader.
  template <typename Chunk>
  void ForEach(Offset count, bool isShared, const Chunk& chunk)
  {
    if (count < 2 || !isShared)
    {
      for (Offset i = 0; i < count; ++i)
      {
        chunk(i);
      }
      return;
    }
    this->Body = std::cref(chunk);
    this->Done = 0;
    this->Left.store(count, std::memory_order_release);
    while (this->TakeChunk())
    {
    }
    while (this->Done.load(std::memory_order_acquire) < count)
    {
      std::this_thread::yield();
    }
    if (this->Thrown)
    {
      std::rethrow_exception(std::exchange(this->Thrown, nullptr));
    }
  }

private:
  static constexpr Offset LargestTeam = 64;
  static constexpr int SpinsBeforeYield = 256;
  static constexpr std::chrono::milliseconds Patience{ 20 };

  RoundTeam() = default;

  bool TakeChunk()
  {
    if (this->Left.load(std::memory_order_acquire) <= 0)
    {
      return false;
    }
    const Offset mine = this->Left.fetch_sub(1, std::memory_order_acq_rel) - 1;
    if (mine < 0)
    {
      return false;
    }
    try
    {
      this->Body(mine);
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Thrown = this->Thrown ? this->Thrown : std::current_exception();
    }
    this->Done.fetch_add(1, std::memory_order_acq_rel);
    return true;
  }

  /// Take chunks until the end, or until nobody has come to lead for long.
  void Follow()
  {
    ++this->Followers;
    const auto start = std::chrono::steady_clock::now();
    int spins = 0;
    while (!this->IsOver.load(std::memory_order_acquire))
    {
      if (!this->IsLed.load(std::memory_order_acquire) &&
        std::chrono::steady_clock::now() - start > Patience)
      {
        break;
      }
      if (this->TakeChunk())
      {
        spins = 0;
      }
      else if (spins < SpinsBeforeYield)
      {
        ++spins;
      }
      else
      {
        std::this_thread::yield();
      }
    }
    --this->Followers;
  }

  std::function<void(Offset)> Body;
  std::atomic<Offset> Left{ 0 };
  std::atomic<Offset> Done{ 0 };
  std::atomic<int> Followers{ 0 };
  std::atomic<bool> IsLed{ false };
  std::atomic<bool> IsOver{ false };
  std::mutex Mutex;
  std::exception_ptr Thrown;
};
}

#endif
