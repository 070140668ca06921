// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Threads that run the loops of the kernel.
#ifndef ThreadPool_h
#define ThreadPool_h

#include "dggParallel.h" // for ParallelFor

namespace dggPython
{
/// Throws a ValueError unless a loop may have this number of threads.
void CheckNumberOfThreads(int count);

///@{
/// Set and return the number of threads of calls that do not choose one. Default: the number of
/// processors that the process may use.
void SetDefaultNumberOfThreads(int count);
int GetDefaultNumberOfThreads();
///@}

/// Returns a function that runs loops on the calling thread and on threads of the pool. Loops
/// within loops run on one thread. The calling thread calls `progress` between its ranges, and
/// while it waits for other threads.
dgg::ParallelFor MakeParallelFor(int numberOfThreads, const dgg::ProgressCallback& progress);

/// Replaces the pool in a child process, which has none of the threads.
void ReplaceThreadPool();
}

#endif
