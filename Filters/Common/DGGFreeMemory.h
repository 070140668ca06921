// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How much memory there is. Internal.
#ifndef DGGFreeMemory_h
#define DGGFreeMemory_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggTypes.h"                  // for Status

#include "vtkType.h" // for vtkTypeUInt64

#include <string> // for messages

/// The limit that a property asks for: itself, or when it is 0, 70 % of what is free by the
/// machine, the limits of the process and, on Linux, of its control groups. The largest number when
/// nothing is known.
VTKDGGFILTERSCOMMON_EXPORT vtkTypeUInt64 DGGGetMemoryLimit(vtkTypeUInt64 property);

/// Bytes that control groups leave this process: the least that the group itself or any around it
/// has free. The largest number when nothing limits it. `membership` is the file that names the
/// groups of the process (/proc/self/cgroup), `mount` where groups are mounted (/sys/fs/cgroup).
VTKDGGFILTERSCOMMON_EXPORT vtkTypeUInt64 DGGGetFreeInControlGroup(
  const std::string& membership, const std::string& mount);

/// Fails when `bytes` are more than the limit that a property asks for. `what` would take them;
/// `remedy` is what to do besides raising MemoryLimit.
VTKDGGFILTERSCOMMON_EXPORT dgg::Status DGGCheckMemory(
  const std::string& what, double bytes, vtkTypeUInt64 property, const std::string& remedy);

#endif
