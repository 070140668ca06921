// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What differs between VTK 9.1 and later versions. Internal.
#ifndef DGGCompatibility_h
#define DGGCompatibility_h

#include "vtkVersionMacros.h" // for VTK_VERSION_NUMBER

/// Whether the user wants the algorithm to stop. Newer VTK also asks the filters upstream.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#define vtkDGGIsAbortedMacro(algorithm) ((algorithm)->CheckAbort())
#else
#define vtkDGGIsAbortedMacro(algorithm) ((algorithm)->GetAbortExecute() != 0)
#endif

#endif
