// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGParallel.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <mutex>
#include <string>
#include <thread>

namespace
{
/// Steps for each thread between two looks at the progress.
constexpr std::size_t StepsPerThread = 8;
/// How often a thread that waits for others tells their progress.
constexpr std::chrono::milliseconds PollInterval(10);

/// The error of the step with the smallest number.
class FirstFailure
{
public:
  /// Whether a step has to run: it may be the first one to fail, and none was stopped.
  bool Allows(std::size_t number) const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Failure.IsOk() || (number < this->Number && !this->Failure.IsAborted());
  }
  void Add(std::size_t number, const dgg::Status& status)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!status.IsOk() && (this->Failure.IsOk() || number < this->Number))
    {
      this->Failure = status;
      this->Number = number;
    }
  }
  /// Only while no step runs.
  const dgg::Status& GetStatus() const { return this->Failure; }

private:
  mutable std::mutex Mutex;
  dgg::Status Failure;
  std::size_t Number = 0;
};

/// Progress of steps in several threads, told by the thread that made it.
class SharedProgress
{
public:
  SharedProgress(const dgg::ProgressCallback& progress, std::size_t count)
    : Progress(progress)
    , Count(static_cast<double>(count))
    , Teller(std::this_thread::get_id())
  {
  }

  /// Part of all steps that is done, between them.
  bool Tell(double done)
  {
    this->Sum = done * this->Count;
    return !this->IsStopped && this->Progress(done);
  }
  /// Of one step, in its thread, which keeps what it has `told`.
  bool TellWithin(double fraction, double& told)
  {
    this->Add(fraction - told);
    told = std::max(told, fraction);
    if (std::this_thread::get_id() == this->Teller)
    {
      this->Poll();
    }
    return !this->IsStopped;
  }
  /// What all steps together have told.
  void Poll()
  {
    if (!this->IsStopped)
    {
      this->IsStopped = !this->Progress(std::min(1.0, this->Sum / this->Count));
    }
  }

private:
  void Add(double part)
  {
    double sum = this->Sum;
    while (part > 0.0 && !this->Sum.compare_exchange_weak(sum, sum + part))
    {
    }
  }

  const dgg::ProgressCallback& Progress;
  double Count;
  std::thread::id Teller;
  std::atomic<double> Sum{ 0.0 }; // of the parts of all steps that are done
  std::atomic<bool> IsStopped{ false };
};

/// Whether the thread that calls vtkSMPTools waits while others do the work.
bool IsCallerIdle()
{
  const char* backend = vtkSMPTools::GetBackend();
  return backend && std::string(backend) == "STDThread";
}

/// Steps that threads take one after the other.
class StepQueue
{
public:
  StepQueue(std::size_t first, std::size_t end, const std::function<void(std::size_t)>& step)
    : Next(first)
    , End(end)
    , Step(step)
  {
  }

  /// Do steps until none is left. What one throws ends all.
  void Run()
  {
    try
    {
      for (std::size_t number = this->Next++; number < this->End; number = this->Next++)
      {
        this->Step(number);
      }
    }
    catch (...)
    {
      this->Next = this->End;
      throw;
    }
  }

private:
  std::atomic<std::size_t> Next;
  const std::size_t End;
  const std::function<void(std::size_t)>& Step;
};

/// Steps from `first` to before `end`, several at once.
void RunBlock(std::size_t first, std::size_t end, const std::function<void(std::size_t)>& step)
{
  if (end - first == 1)
  {
    step(first);
    return;
  }
  vtkDGGMakeParallelFor()(
    static_cast<dgg::Offset>(end - first), 1, [&](dgg::Offset begin, dgg::Offset stop) {
      for (dgg::Offset i = begin; i < stop; ++i)
      {
        step(first + static_cast<std::size_t>(i));
      }
    });
}

/// The same where this thread calls `poll` now and then while it has nothing else to do: it does
/// steps as the others do, but need not wait for the last of these without a word.
void RunPolledBlock(std::size_t first, std::size_t end, const std::function<void()>& poll,
  const std::function<void(std::size_t)>& step)
{
  const auto others = std::min<dgg::Offset>(
    vtkSMPTools::GetEstimatedNumberOfThreads() - 1, static_cast<dgg::Offset>(end - first) - 1);
  StepQueue queue(first, end, step);
  if (others < 1)
  {
    queue.Run();
    return;
  }
  std::future<void> done = std::async(std::launch::async, [&] {
    vtkDGGMakeParallelFor()(others, 1, [&](dgg::Offset begin, dgg::Offset stop) {
      for (dgg::Offset i = begin; i < stop; ++i)
      {
        queue.Run();
      }
    });
  });
  queue.Run(); // the future waits for the others even where this throws
  while (done.wait_for(PollInterval) != std::future_status::ready)
  {
    poll();
  }
  done.get();
}

dgg::Status RunBlocks(std::size_t count, std::size_t block, const dgg::ProgressCallback& progress,
  const std::function<void()>& poll, const std::function<dgg::Status(std::size_t)>& step)
{
  const auto threads = static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
  const std::size_t size = std::max(block, StepsPerThread * std::max<std::size_t>(threads, 1));
  FirstFailure failure;
  for (std::size_t first = 0; first < count && failure.GetStatus().IsOk(); first += size)
  {
    const std::size_t end = std::min(count, first + size);
    const auto run = [&](std::size_t number) {
      if (failure.Allows(number))
      {
        failure.Add(number, step(number));
      }
    };
    if (poll)
    {
      RunPolledBlock(first, end, poll, run);
    }
    else
    {
      RunBlock(first, end, run);
    }
    const double done = static_cast<double>(end) / static_cast<double>(count);
    if (failure.GetStatus().IsOk() && !progress(done))
    {
      return dgg::Status::Abort();
    }
  }
  return failure.GetStatus();
}
}

//------------------------------------------------------------------------------
dgg::ParallelFor vtkDGGMakeParallelFor()
{
  return [](dgg::Offset size, dgg::Offset grain,
           const std::function<void(dgg::Offset, dgg::Offset)>& body) {
    std::mutex mutex;
    std::exception_ptr thrown;
    auto guarded = [&](vtkIdType begin, vtkIdType end) {
      try
      {
        body(begin, end);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        thrown = thrown ? thrown : std::current_exception();
      }
    };
    vtkSMPTools::For(0, size, grain, guarded);
    if (thrown)
    {
      std::rethrow_exception(thrown);
    }
  };
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGForBlocks(std::size_t count, std::size_t block,
  const dgg::ProgressCallback& progress, const std::function<dgg::Status(std::size_t)>& step)
{
  return RunBlocks(count, block, progress, nullptr, step);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGForLongSteps(std::size_t count, const dgg::ProgressCallback& progress,
  const std::function<dgg::Status(std::size_t, const dgg::ProgressCallback&)>& step)
{
  SharedProgress shared(progress, count);
  return RunBlocks(
    count, 1, [&](double done) { return shared.Tell(done); }, [&] { shared.Poll(); },
    [&](std::size_t number) {
      double told = 0.0;
      const dgg::Status status =
        step(number, [&](double fraction) { return shared.TellWithin(fraction, told); });
      if (status.IsOk())
      {
        shared.TellWithin(1.0, told);
      }
      return status;
    });
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGRunTold(const dgg::ProgressCallback& progress,
  const std::function<dgg::Status(const dgg::ProgressCallback&)>& work)
{
  SharedProgress shared(progress, 1);
  double told = 0.0; // by one thread at a time
  const auto run = [&] {
    return work([&](double fraction) { return shared.TellWithin(fraction, told); });
  };
  if (!IsCallerIdle())
  {
    return run();
  }
  std::future<dgg::Status> done = std::async(std::launch::async, run);
  while (done.wait_for(PollInterval) != std::future_status::ready)
  {
    shared.Poll();
  }
  return done.get();
}
