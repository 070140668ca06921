// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGFreeMemory.h"

#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <fstream>

/// Returns the first number in a file, or the number after a key; `missing` if there is none, such
/// as for the value "max".
static vtkTypeUInt64 Read(const std::string& path, const std::string& key, vtkTypeUInt64 missing)
{
  std::ifstream file(path);
  std::string name;
  vtkTypeUInt64 value = 0;
  while ((key.empty() || file >> name) && file >> value && name != key)
  {
  }
  return file ? value : missing;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 DGGGetFreeInControlGroup(const std::string& membership, const std::string& mount)
{
  constexpr vtkTypeUInt64 unlimited = VTK_TYPE_UINT64_MAX;
  const char* const versions[][5] = { { "", "0::", "max", "current", "inactive_file" },
    { "/memory", "memory", "limit_in_bytes", "usage_in_bytes", "total_inactive_file" } };
  vtkTypeUInt64 free = unlimited;
  for (const auto& [folder, controller, limitName, usageName, filesName] : versions)
  {
    std::string group; // in a container, possibly the path of the host
    std::ifstream file(membership);
    for (std::string line; std::getline(file, line);) // "number:controllers:/path"
    {
      const std::size_t path = line.find(":/") + 1;
      group = line.substr(0, path).find(controller) < path ? line.substr(path) : group;
    }
    for (bool isRoot = false; !isRoot; group.resize(isRoot ? 0 : group.rfind('/')))
    {
      isRoot = group.empty();
      const std::string files = mount + folder + group + "/memory.";
      const vtkTypeUInt64 limit = Read(files + limitName, "", unlimited);
      const vtkTypeUInt64 used = Read(files + usageName, "", 0);
      const vtkTypeUInt64 reclaimable = std::min(used, Read(files + "stat", filesName, 0));
      free =
        limit == unlimited ? free : std::min(free, limit - std::min(limit, used - reclaimable));
    }
  }
  return free;
}

//------------------------------------------------------------------------------
static std::uint64_t FindAvailable()
{
  constexpr double share = 0.7;
  vtksys::SystemInformation system; // in KiB
  const long long total = system.GetHostMemoryTotal();
  const long long left = std::min<long long>(total - system.GetHostMemoryUsed(),
    system.GetProcMemoryAvailable() - system.GetProcMemoryUsed());
  const auto machine = 1024 * static_cast<std::uint64_t>(std::max(0LL, left));
  const auto group = DGGGetFreeInControlGroup("/proc/self/cgroup", "/sys/fs/cgroup");
  return total <= 0 ? VTK_TYPE_UINT64_MAX // unknown
                    : static_cast<std::uint64_t>(
                        share * static_cast<double>(std::min<std::uint64_t>(machine, group)));
}

//------------------------------------------------------------------------------
dgg::MemoryBudget DGGMakeBudget(vtkTypeInt64 property)
{
  return { static_cast<std::uint64_t>(property), &FindAvailable };
}
