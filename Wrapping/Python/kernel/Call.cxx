// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Call.h"

#include "Arguments.h"
#include "Errors.h"
#include "Surface.h"
#include "ThreadPool.h"

#include "dggFreeMemory.h"

#include <algorithm>

namespace dggPython
{
namespace
{
constexpr std::chrono::milliseconds ReportInterval(10);
}

//------------------------------------------------------------------------------
Call::Call(Arguments& arguments)
  : Keywords(arguments)
  , Progress(arguments.Take("progress"))
  , NumberOfThreads(GetDefaultNumberOfThreads())
  , Caller(std::this_thread::get_id())
{
  arguments.Read("memory_limit", this->MemoryLimit);
  arguments.Read("number_of_threads", this->NumberOfThreads);
  if (this->MemoryLimit < 0)
  {
    throw py::value_error("memory_limit: expected a number of bytes, or 0 for the default, got " +
      std::to_string(this->MemoryLimit));
  }
  CheckNumberOfThreads(this->NumberOfThreads);
  if (this->Progress && !PyCallable_Check(this->Progress.ptr()))
  {
    throw py::type_error("progress: expected a callable");
  }
}

//------------------------------------------------------------------------------
dgg::ProgressCallback Call::GetProgress()
{
  return [this](double done) { return this->Advance(done); };
}

//------------------------------------------------------------------------------
dgg::TaskContext Call::MakeContext(const Surface& surface)
{
  const dgg::ProgressCallback progress = this->GetProgress();
  return { surface.Get(), dgg::MakeBudget(this->MemoryLimit), this->NumberOfThreads, progress,
    MakeParallelFor(this->NumberOfThreads, progress),
    [&surface]() -> const dgg::SurfaceArrays& { return surface.GetCells(); } };
}

//------------------------------------------------------------------------------
void Call::Run(const std::function<dgg::Status()>& step)
{
  this->Keywords.Finish();
  dgg::Status status;
  this->Report();
  if (!this->IsStopped)
  {
    const py::gil_scoped_release release;
    status = step();
    this->Advance(status.IsOk() ? 1.0 : 0.0);
  }
  if (!this->IsStopped)
  {
    this->Report(); // of the end, and of signals of the last moment
  }
  if (this->Thrown)
  {
    std::rethrow_exception(this->Thrown);
  }
  ThrowUnlessOk(status);
}

//------------------------------------------------------------------------------
/// Called by any thread. Returns false if the work must stop.
bool Call::Advance(double fraction)
{
  double before = this->Reached;
  while (before < fraction && !this->Reached.compare_exchange_weak(before, fraction))
  {
  }
  if (!this->IsStopped && std::this_thread::get_id() == this->Caller &&
    std::chrono::steady_clock::now() >= this->Due)
  {
    const py::gil_scoped_acquire acquire;
    this->Report();
  }
  return !this->IsStopped;
}

//------------------------------------------------------------------------------
/// Handles signals and reports progress, with the interpreter lock.
void Call::Report()
{
  try
  {
    if (PyErr_CheckSignals() != 0)
    {
      throw py::error_already_set();
    }
    if (this->Progress)
    {
      this->Progress(std::min(1.0, this->Reached.load()));
    }
  }
  catch (...)
  {
    this->Thrown = std::current_exception();
    this->IsStopped = true;
  }
  this->Due = std::chrono::steady_clock::now() + ReportInterval;
}
}
