// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops of the kernel on the threads of VTK. Internal.
#ifndef vtkDGGParallel_h
#define vtkDGGParallel_h

#include "dggParallel.h" // for ParallelFor

/// Runs loops by vtkSMPTools. What a loop throws in any thread is thrown to the caller, after the
/// loop: an exception that leaves a thread would end the program.
dgg::ParallelFor vtkDGGMakeParallelFor();

#endif
// VTK-HeaderTest-Exclude: vtkDGGParallel.h
