// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The default memory limit, from the memory that the system leaves free. Internal.
#ifndef dggFreeMemory_h
#define dggFreeMemory_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggMemoryLimit.h" // for MemoryBudget

#include <cstdint> // for bytes
#include <string>  // for paths

namespace dgg
{
/// Returns the memory budget of an update for the property MemoryLimit. If the property is 0, the
/// limit is 70 % of the memory that the machine, the limits of the process and, on Linux, its
/// control groups leave free; there is no limit if the free memory is unknown.
DGG_CORE_EXPORT MemoryBudget MakeBudget(Offset property);

/// Returns the number of bytes that control groups leave to this process: the minimum over its
/// group and all enclosing groups; the largest integer if there is no limit. `membership` is the
/// file that names the groups of the process (/proc/self/cgroup), `mount` the mount point of the
/// groups (/sys/fs/cgroup).
DGG_CORE_EXPORT std::uint64_t GetFreeInControlGroup(
  const std::string& membership, const std::string& mount);
}

#endif
