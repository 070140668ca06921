// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A call of the kernel: threads, memory, progress and interruption.
#ifndef Call_h
#define Call_h

#include "dggStatus.h"      // for Status
#include "dggTaskContext.h" // for TaskContext
#include "dggTypes.h"       // for ProgressCallback

#include <pybind11/pybind11.h>

#include <atomic>     // for the progress
#include <chrono>     // for the progress
#include <exception>  // for exceptions of callables
#include <functional> // for steps
#include <thread>     // for the calling thread

namespace dggPython
{
namespace py = pybind11;

class Arguments;
class Surface;

/// A call of the kernel from Python. The calling thread checks for signals and reports progress
/// about a hundred times per second; it needs the interpreter lock for both, and for nothing else.
class Call
{
public:
  /// Reads `memory_limit`, `number_of_threads` and `progress`.
  explicit Call(Arguments& arguments);
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  /// Returns the callback that reports progress and stops the work. This object must outlive it.
  dgg::ProgressCallback GetProgress();

  /// Returns the context of a task. The surface must outlive it, as this object must.
  dgg::TaskContext MakeContext(const Surface& surface);

  /// Runs a step without the interpreter lock, after all arguments have been read. Throws the
  /// exception of a signal handler or of the callable, or the error of the step.
  void Run(const std::function<dgg::Status()>& step);

private:
  bool Advance(double fraction);
  void Report();

  Arguments& Keywords;
  py::object Progress; // null if there is none
  dgg::Offset MemoryLimit = 0;
  int NumberOfThreads;
  std::thread::id Caller;
  std::chrono::steady_clock::time_point Due; // of the next report; only used by the caller
  std::atomic<double> Reached{ 0.0 };
  std::atomic<bool> IsStopped{ false };
  std::exception_ptr Thrown;
};
}

#endif
