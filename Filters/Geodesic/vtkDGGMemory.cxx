// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGMemory.h"

#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>

namespace
{
constexpr double DefaultShare = 0.7;
constexpr vtkTypeUInt64 Unlimited = std::numeric_limits<vtkTypeUInt64>::max();

vtkTypeUInt64 Difference(long long total, long long used)
{
  return total > used ? static_cast<vtkTypeUInt64>(total - used) : 0;
}

/// A number in a file; `Unlimited` when there is none, as in "max".
vtkTypeUInt64 ReadNumber(const char* path)
{
  std::ifstream file(path);
  vtkTypeUInt64 value = 0;
  return file >> value ? value : Unlimited;
}

/// The number behind a key in a file of "key number" lines; 0 when there is none.
vtkTypeUInt64 ReadKey(const char* path, const std::string& key)
{
  std::ifstream file(path);
  std::string name;
  vtkTypeUInt64 value = 0;
  while (file >> name >> value)
  {
    if (name == key)
    {
      return value;
    }
  }
  return 0;
}

struct ControlGroup
{
  const char* Limit;
  const char* Usage;
  const char* Statistics;
  const char* Reclaimable; // pages of files, which are counted as used
};

/// What the control group of a container leaves. Other groups than that at the root of the mounted
/// hierarchy are not looked for: inside a container it is the container's.
vtkTypeUInt64 GetFreeInControlGroup()
{
  const ControlGroup versions[] = {
    { "/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current", "/sys/fs/cgroup/memory.stat",
      "inactive_file" },
    { "/sys/fs/cgroup/memory/memory.limit_in_bytes", "/sys/fs/cgroup/memory/memory.usage_in_bytes",
      "/sys/fs/cgroup/memory/memory.stat", "total_inactive_file" },
  };
  vtkTypeUInt64 free = Unlimited;
  for (const ControlGroup& group : versions)
  {
    const vtkTypeUInt64 limit = ReadNumber(group.Limit);
    const vtkTypeUInt64 used = ReadNumber(group.Usage);
    if (limit != Unlimited && used != Unlimited)
    {
      const vtkTypeUInt64 kept =
        used - std::min(used, ReadKey(group.Statistics, group.Reclaimable));
      free = std::min(free, limit - std::min(limit, kept));
    }
  }
  return free;
}
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDGGGetFreeMemory()
{
  vtksys::SystemInformation system; // in KiB
  const long long total = system.GetHostMemoryTotal();
  if (total <= 0)
  {
    return Unlimited;
  }
  const vtkTypeUInt64 machine = Difference(total, system.GetHostMemoryUsed());
  const vtkTypeUInt64 process =
    Difference(system.GetProcMemoryAvailable(), system.GetProcMemoryUsed());
  return std::min(1024 * std::min(machine, process), GetFreeInControlGroup());
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDGGGetMemoryLimit(vtkTypeUInt64 property)
{
  if (property != 0)
  {
    return property;
  }
  const vtkTypeUInt64 free = vtkDGGGetFreeMemory();
  return free == Unlimited ? Unlimited
                           : static_cast<vtkTypeUInt64>(DefaultShare * static_cast<double>(free));
}

//------------------------------------------------------------------------------
std::string vtkDGGFormatBytes(double bytes)
{
  const char* const units[] = { "bytes", "KiB", "MiB", "GiB", "TiB" };
  std::size_t unit = 0;
  while (bytes >= 1024.0 && unit + 1 < sizeof(units) / sizeof(units[0]))
  {
    bytes /= 1024.0;
    ++unit;
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g %s", bytes, units[unit]);
  return text;
}
