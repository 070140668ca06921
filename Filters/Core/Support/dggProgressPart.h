// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Progress of one step of a sequence. Internal.
#ifndef dggProgressPart_h
#define dggProgressPart_h

#include "dggStatus.h" // for Status

namespace dgg
{
/// Reports progress. Returns true if the work should continue.
inline bool ShouldContinue(const ProgressCallback& progress, double fraction)
{
  return !progress || progress(fraction);
}

/// Like ShouldContinue(), but returns a Status.
inline Status ReportTo(const ProgressCallback& progress, double fraction)
{
  return ShouldContinue(progress, fraction) ? Status::Success() : Status::Abort();
}

/// Returns the progress callback of a step that covers the interval [begin, end] of the total:
/// fractions 0 and 1 of the step map to the ends of the interval. Empty if `progress` is empty.
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
