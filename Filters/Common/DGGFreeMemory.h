// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Memory limits from properties and from the system. Internal.
#ifndef DGGFreeMemory_h
#define DGGFreeMemory_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggMemoryLimit.h"            // for MemoryBudget

#include "vtkType.h" // for vtkTypeUInt64

#include <string> // for paths

/// Makes the budget of an update from the property MemoryLimit. If that is 0, the limit is 70 % of
/// what the machine, the limits of the process and, on Linux, its control groups leave free;
/// unlimited where that is unknown.
VTKDGGFILTERSCOMMON_EXPORT dgg::MemoryBudget DGGMakeBudget(vtkTypeInt64 property);

/// Bytes that control groups leave this process: the least that the group itself or any around it
/// has free. The largest number when nothing limits it. `membership` is the file that names the
/// groups of the process (/proc/self/cgroup), `mount` where groups are mounted (/sys/fs/cgroup).
VTKDGGFILTERSCOMMON_EXPORT vtkTypeUInt64 DGGGetFreeInControlGroup(
  const std::string& membership, const std::string& mount);

#endif
