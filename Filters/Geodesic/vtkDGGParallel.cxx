// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGParallel.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <exception>
#include <mutex>

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
  const dgg::ParallelFor parallel = vtkDGGMakeParallelFor();
  dgg::Status failure;
  std::size_t failed = count;
  std::mutex mutex;
  for (std::size_t first = 0; first < count && failure.IsOk(); first += block)
  {
    const std::size_t size = std::min(block, count - first);
    parallel(static_cast<dgg::Offset>(size), 1, [&](dgg::Offset begin, dgg::Offset end) {
      for (dgg::Offset i = begin; i < end; ++i)
      {
        const std::size_t number = first + static_cast<std::size_t>(i);
        const dgg::Status status = step(number);
        const std::lock_guard<std::mutex> lock(mutex);
        if (!status.IsOk() && number < failed)
        {
          failure = status;
          failed = number;
        }
      }
    });
    const double done = static_cast<double>(first + size) / static_cast<double>(count);
    if (failure.IsOk() && !progress(done))
    {
      failure = dgg::Status::Abort();
    }
  }
  return failure;
}

//------------------------------------------------------------------------------
vtkDGGSharedProgress::vtkDGGSharedProgress(const dgg::ProgressCallback& progress, std::size_t count)
  : Progress(progress)
  , Count(static_cast<double>(count))
  , Teller(std::this_thread::get_id())
{
}

//------------------------------------------------------------------------------
dgg::ProgressCallback vtkDGGSharedProgress::OfStep()
{
  return [this](double fraction) {
    if (std::this_thread::get_id() == this->Teller && !this->IsStopped)
    {
      this->IsStopped = !this->Progress(this->Done + (1.0 - this->Done) * fraction / this->Count);
    }
    return !this->IsStopped;
  };
}

//------------------------------------------------------------------------------
bool vtkDGGSharedProgress::Tell(double done)
{
  this->Done = done;
  return !this->IsStopped && this->Progress(done);
}
