// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How the kernel, which has no threads of its own, lets its caller run loops in parallel.
#ifndef dggParallel_h
#define dggParallel_h

#include "dggTypes.h" // for Offset

#include <functional> // for std::function

namespace dgg
{
/// Runs `body(begin, end)` over disjoint ranges of about `grain` that make up [0, size), at the
/// same time if it likes; that from 0 on in the calling thread. What it throws there reaches the
/// caller after the loop. Empty means one after the other. Results never depend on it.
using ParallelFor =
  std::function<void(Offset size, Offset grain, const std::function<void(Offset, Offset)>& body)>;

/// Run a loop as the caller wants it.
inline void ForRange(const ParallelFor& parallel, Offset size, Offset grain,
  const std::function<void(Offset, Offset)>& body)
{
  if (size <= 0)
  {
    return;
  }
  if (parallel)
  {
    parallel(size, grain, body);
  }
  else
  {
    body(0, size);
  }
}
}

#endif
