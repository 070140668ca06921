// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Interface by which callers run the loops of the kernel in parallel; the kernel starts no
/// threads.
#ifndef dggParallel_h
#define dggParallel_h

#include "dggTypes.h" // for Offset

#include <functional> // for std::function

namespace dgg
{
/// Runs `body(begin, end)` over disjoint ranges of about `grain` elements that cover [0, size),
/// possibly in parallel. The calling thread runs the range that begins at 0, without waiting for
/// other ranges; exceptions of that range are forwarded to the caller after the loop. An empty
/// function means sequential execution. Results never depend on it.
using ParallelFor =
  std::function<void(Offset size, Offset grain, const std::function<void(Offset, Offset)>& body)>;

/// Runs a loop in parallel if `parallel` is set, otherwise sequentially.
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
