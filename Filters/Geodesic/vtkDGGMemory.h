// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How much memory there is, and how to say how much. Internal.
#ifndef vtkDGGMemory_h
#define vtkDGGMemory_h

#include "dggTypes.h" // for Status

#include "vtkType.h" // for vtkTypeUInt64

#include <string> // for messages

/// Bytes that this process can still use: what the machine, the limits of the process and, on
/// Linux, those of its control group leave. The largest number when nothing is known.
vtkTypeUInt64 vtkDGGGetFreeMemory();

/// The limit that a property stands for: itself, or 70 % of what is free when it is 0.
vtkTypeUInt64 vtkDGGGetMemoryLimit(vtkTypeUInt64 property);

/// "1.53 GiB"
std::string vtkDGGFormatBytes(double bytes);

/// Fails when `bytes` are more than the limit that a property stands for. `what` would take them;
/// `remedy` is what to do besides raising MemoryLimit.
dgg::Status vtkDGGCheckMemory(
  const std::string& what, double bytes, vtkTypeUInt64 property, const std::string& remedy);

#endif
// VTK-HeaderTest-Exclude: vtkDGGMemory.h
