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
/// same time if it likes. The calling thread runs the range that begins at 0, without waiting for
/// others before; what that throws reaches it after the loop. Empty means one after the other.
/// Results never depend on it.
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
