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

/// Returns the memory budget of an update for the property MemoryLimit. If the property is 0, the
/// limit is 70 % of the memory that the machine, the limits of the process and, on Linux, its
/// control groups leave free; there is no limit if the free memory is unknown.
VTKDGGFILTERSCOMMON_EXPORT dgg::MemoryBudget DGGMakeBudget(vtkTypeInt64 property);

/// Returns the number of bytes that control groups leave to this process: the minimum over its
/// group and all enclosing groups; the largest integer if there is no limit. `membership` is the
/// file that names the groups of the process (/proc/self/cgroup), `mount` the mount point of the
/// groups (/sys/fs/cgroup).
VTKDGGFILTERSCOMMON_EXPORT vtkTypeUInt64 DGGGetFreeInControlGroup(
  const std::string& membership, const std::string& mount);

#endif
