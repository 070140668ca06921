// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A team of threads for many consecutive short loops. Internal.
#ifndef dggRoundTeam_h
#define dggRoundTeam_h

#include "dggParallel.h" // for ParallelFor

#include <array>      // for per-thread data
#include <atomic>     // for shared data
#include <chrono>     // for naps
#include <cstdint>    // for std::int32_t
#include <exception>  // for exceptions of chunks
#include <functional> // for the loops
#include <mutex>      // for the first exception
#include <numeric>    // for std::accumulate
#include <thread>     // for std::this_thread::yield
#include <utility>    // for std::exchange

namespace dgg
{
/// Runs thousands of short rounds, each of which is parallel. Starting threads for each round would
/// take longer than the rounds. Therefore threads are started once; one leads, and the others wait
/// actively for chunks of the current round. The leader never waits for a thread that has not taken
/// a chunk, so that threads may be missing.
///
/// Transferring a cache line between threads costs as much as several labels. Therefore each chunk
/// belongs to a thread, other threads only take chunks that it has not begun, and each thread
/// writes to cache lines of its own.
class RoundTeam
{
public:
  /// Maximum team size; more threads would not find enough work.
  static constexpr int LargestTeam = 16;
  using Counts = std::array<Offset, LargestTeam>; ///< per thread

  /// Calls lead(team) in this thread, with up to `threads` threads in total. Exceptions are
  /// forwarded to the caller. `lead` must not wait for parallel loops of other threads, which may
  /// be members of this team.
  template <typename Lead>
  static void Run(const ParallelFor& parallel, int threads, Lead&& lead)
  {
    RoundTeam team(parallel ? threads : 1);
    ForRange(parallel, team.Size, 1, [&](Offset begin, Offset) {
      if (begin > 0)
      {
        team.Follow();
        return;
      }
      const End end{ team };
      lead(team);
    });
  }

  /// Returns true if other threads have joined. Queried once per round: it decides whether the
  /// steps of a round need synchronization.
  bool IsShared() const { return this->NumberOfMembers.load(std::memory_order_acquire) > 1; }

  /// Calls chunk(owner, i, thread) for all i below counts[owner], concurrently if the round is
  /// shared. Only for the leader, which is thread 0.
  template <typename Chunk>
  void ForEach(const Counts& counts, bool isShared, const Chunk& chunk)
  {
    const Offset count = std::accumulate(counts.begin(), counts.end(), Offset(0));
    if (count < 2 || !isShared)
    {
      for (std::size_t owner = 0; owner < counts.size(); ++owner)
      {
        for (Offset i = 0; i < counts[owner]; ++i)
        {
          chunk(static_cast<int>(owner), i, 0);
        }
      }
      return;
    }
    this->Body = std::cref(chunk);
    ++this->Round;
    const int size = this->Size;
    for (int m = 0; m < size; ++m)
    {
      this->Members[m].Done.store(0, std::memory_order_relaxed);
    }
    for (int m = size - 1; m >= 0; --m)
    {
      const Range range{ 0, static_cast<std::int32_t>(counts[m]) };
      this->Members[m].Left.store(range, std::memory_order_release);
      this->Members[m].Round.store(this->Round, std::memory_order_release);
    }
    this->Work(0);
    int spins = 0;
    while (this->CountDone() < count)
    {
      Wait(spins);
    }
    if (this->Thrown)
    {
      std::rethrow_exception(std::exchange(this->Thrown, nullptr));
    }
  }

private:
  static constexpr int SpinsBeforeYield = 256;
  /// Threads without work sleep after this many spins, to leave the processor to others, such as
  /// the leader.
  static constexpr int SpinsBeforeSleep = 2000;
  static constexpr std::chrono::microseconds Nap{ 50 };

  /// Chunks that have not been started: their owner takes the first one, other threads the last
  /// one.
  struct alignas(8) Range
  {
    std::int32_t Begin;
    std::int32_t End;
  };
  struct Member
  {
    alignas(64) std::atomic<Range> Left{ Range{ 0, 0 } };
    std::atomic<int> Round{ 0 };               ///< round of the range
    alignas(64) std::atomic<Offset> Done{ 0 }; ///< number of chunks completed by this thread
  };

  /// Signals the end to the other members when destroyed, also on exceptions.
  struct End
  {
    RoundTeam& Team;
    ~End() { this->Team.IsOver.store(true, std::memory_order_release); }
  };

  explicit RoundTeam(int size)
    : Size(size)
  {
  }

  Offset CountDone() const
  {
    Offset done = 0;
    const int size = this->Size;
    for (int m = 0; m < size; ++m)
    {
      done += this->Members[m].Done.load(std::memory_order_acquire);
    }
    return done;
  }

  static void Wait(int& spins)
  {
    ++spins;
    if (spins > SpinsBeforeSleep)
    {
      spins = SpinsBeforeSleep;
      std::this_thread::sleep_for(Nap);
    }
    else if (spins > SpinsBeforeYield)
    {
      std::this_thread::yield();
    }
  }

  bool TakeChunk(int owner, bool isFirst, Offset& chunk)
  {
    std::atomic<Range>& left = this->Members[owner].Left;
    Range range = left.load(std::memory_order_acquire);
    while (range.Begin < range.End)
    {
      const Range rest =
        isFirst ? Range{ range.Begin + 1, range.End } : Range{ range.Begin, range.End - 1 };
      chunk = isFirst ? range.Begin : range.End - 1;
      if (left.compare_exchange_weak(range, rest, std::memory_order_acq_rel))
      {
        return true;
      }
    }
    return false;
  }

  /// Processes own chunks, then chunks of other members. Returns true if any chunk was processed.
  bool Work(int self)
  {
    bool hasWorked = false;
    const int size = this->Size;
    for (int k = 0; k < size; ++k)
    {
      Offset done = 0;
      Offset chunk = 0;
      const int owner = (self + k) % size;
      while (this->TakeChunk(owner, k == 0, chunk))
      {
        try
        {
          this->Body(owner, chunk, self);
        }
        catch (...)
        {
          const std::lock_guard<std::mutex> lock(this->Mutex);
          this->Thrown = this->Thrown ? this->Thrown : std::current_exception();
        }
        ++done;
      }
      hasWorked = hasWorked || done > 0;
      if (done > 0)
      {
        this->Members[self].Done.fetch_add(done, std::memory_order_acq_rel);
      }
    }
    return hasWorked;
  }

  /// Works until the end is signaled.
  void Follow()
  {
    const int self = this->NumberOfMembers.fetch_add(1, std::memory_order_acq_rel);
    const std::atomic<int>& current = this->Members[self].Round;
    int seen = 0;
    int spins = 0;
    while (!this->IsOver.load(std::memory_order_acquire))
    {
      const int round = current.load(std::memory_order_acquire);
      if (seen != round)
      {
        seen = round;
        spins = this->Work(self) ? 0 : spins;
      }
      else
      {
        Wait(spins);
      }
    }
  }

  const int Size; ///< chunks of missing members are done by others
  std::array<Member, LargestTeam> Members;
  std::function<void(int, Offset, int)> Body;
  int Round = 0;
  std::atomic<int> NumberOfMembers{ 1 }; ///< including the leader
  alignas(64) std::atomic<bool> IsOver{ false };
  std::mutex Mutex;
  std::exception_ptr Thrown;
};
}

#endif
