// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What an update of a filter works with. Not for use outside of vtkDGG.
 */
#ifndef DGGContext_h
#define DGGContext_h

#include "dggParallel.h" // For the loop
#include "dggTypes.h"    // For the progress

#include "vtkType.h" // For the limit

namespace dgg
{
class PreparedSurface;
}
class vtkPolyData;

/// Made once at the start of an update, and handed on to all that has a part in it. Inputs are
/// constant during an update, as everywhere in VTK, so nothing of this changes.
struct DGGContext
{
  vtkPolyData* Input;                  ///< the surface as it came
  const dgg::PreparedSurface& Surface; ///< as the kernel sees it
  vtkTypeUInt64 MemoryLimit;           ///< bytes; 0 for a part of what is free
  /// Of the update; any thread may report. False means stop.
  dgg::ProgressCallback Progress;
  /// On the threads of VTK, with Progress.
  dgg::ParallelFor Parallel;
};

#endif
