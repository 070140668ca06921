// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops on the threads of VTK. Internal.
#ifndef DGGThreads_h
#define DGGThreads_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggParallel.h"               // for ParallelFor
#include "dggTypes.h"                  // for ProgressCallback

/// Runs loops by vtkSMPTools. The calling thread takes part in them; between its ranges, and once
/// nothing is left for it to do, it calls `progress` with 0 now and then until the other threads
/// are done, so that what they have reported reaches the observers of a filter and their wish to
/// abort reaches the loop. What a loop throws in any thread is thrown to the caller, after the
/// loop: an exception that leaves a thread would end the program.
VTKDGGFILTERSCOMMON_EXPORT dgg::ParallelFor DGGMakeParallelFor(
  const dgg::ProgressCallback& progress = dgg::ProgressCallback());

#endif
