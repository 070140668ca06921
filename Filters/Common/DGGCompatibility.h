// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Differences between VTK 9.1 and later versions. Internal.
#ifndef DGGCompatibility_h
#define DGGCompatibility_h

#include "vtkVersionMacros.h" // for VTK_VERSION_NUMBER

/// vtkDGGIsAbortedMacro: true if the algorithm should stop. Since VTK 9.3 also true if an upstream
/// filter was aborted; remains true until vtkDGGClearAbortMacro() or the next update.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#define vtkDGGIsAbortedMacro(algorithm) ((algorithm)->CheckAbort())
#define vtkDGGClearAbortMacro(algorithm) ((algorithm)->SetAbortOutput(false))
#else
#define vtkDGGIsAbortedMacro(algorithm) ((algorithm)->GetAbortExecute() != 0)
#define vtkDGGClearAbortMacro(algorithm)
#endif

#endif
