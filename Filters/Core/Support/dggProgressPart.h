// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The progress of one step of many. Internal.
#ifndef dggProgressPart_h
#define dggProgressPart_h

#include "dggTypes.h" // for ProgressCallback

namespace dgg
{
/// Report progress. Whether the work is to go on.
inline bool Goes(const ProgressCallback& progress, double fraction)
{
  return !progress || progress(fraction);
}

/// The same, as the outcome of a step.
inline Status ReportTo(const ProgressCallback& progress, double fraction)
{
  return Goes(progress, fraction) ? Status::Success() : Status::Abort();
}

/// What a step is given that makes the part [begin, end] of all: its fractions 0 and 1 are these
/// ones of `progress`. Empty when `progress` is.
inline ProgressCallback ProgressPart(const ProgressCallback& progress, double begin, double end)
{
  if (!progress)
  {
    return ProgressCallback();
  }
  return
    [progress, begin, end](double done) { return progress(begin * (1.0 - done) + end * done); };
}
}

#endif
