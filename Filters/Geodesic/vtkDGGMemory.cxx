// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGMemory.h"

#include "dggMemoryLimit.h"

#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <fstream>

namespace
{
constexpr vtkTypeUInt64 Unlimited = static_cast<vtkTypeUInt64>(-1);

/// The number in a file, or behind a key in it; Unlimited when there is none, as for "max".
vtkTypeUInt64 ReadNumber(const std::string& path, const std::string& key = "")
{
  std::ifstream file(path);
  vtkTypeUInt64 value = 0;
  std::string name;
  while ((key.empty() || file >> name) && file >> value)
  {
    if (name == key)
    {
      return value;
    }
  }
  return Unlimited;
}

/// What a control group leaves. Pages of files count as used, but can be had back.
vtkTypeUInt64 GetFreeIn(
  const std::string& folder, const char* limitName, const char* usageName, const char* filesName)
{
  const vtkTypeUInt64 limit = ReadNumber(folder + limitName);
  const vtkTypeUInt64 used = ReadNumber(folder + usageName);
  const vtkTypeUInt64 files = ReadNumber(folder + "/memory.stat", filesName);
  const vtkTypeUInt64 kept = files == Unlimited ? used : used - std::min(used, files);
  return limit == Unlimited || used == Unlimited ? Unlimited : limit - std::min(limit, kept);
}
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDGGGetFreeInControlGroup(const std::string& membership, const std::string& mount)
{
  vtkTypeUInt64 free = Unlimited;
  const auto look = [&](const std::string& path) {
    for (const char* root : { "", "/unified" })
    {
      free = std::min(
        free, GetFreeIn(mount + root + path, "/memory.max", "/memory.current", "inactive_file"));
    }
    free = std::min(free,
      GetFreeIn(mount + "/memory" + path, "/memory.limit_in_bytes", "/memory.usage_in_bytes",
        "total_inactive_file"));
  };
  look(""); // inside a container often its group, where the path is that of the machine
  std::ifstream file(membership);
  for (std::string line; std::getline(file, line);) // "number:controllers:/path"
  {
    const std::size_t end = std::min(line.find(":/"), line.size());
    const bool isMemory =
      line.compare(0, 4, "0::/") == 0 || line.substr(0, end).find("memory") != std::string::npos;
    std::string path = line.substr(std::min(end + 1, line.size()));
    for (; isMemory && path.size() > 1 && path.find("..") == std::string::npos;
         path.resize(path.find_last_of('/')))
    {
      look(path);
    }
  }
  return free;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDGGGetMemoryLimit(vtkTypeUInt64 property)
{
  if (property != 0)
  {
    return property;
  }
  constexpr double share = 0.7;
  vtksys::SystemInformation system; // in KiB
  const long long total = system.GetHostMemoryTotal();
  const long long left = std::min<long long>(total - system.GetHostMemoryUsed(),
    system.GetProcMemoryAvailable() - system.GetProcMemoryUsed());
  const auto machine = 1024 * static_cast<vtkTypeUInt64>(std::max(0LL, left));
  const vtkTypeUInt64 group = vtkDGGGetFreeInControlGroup("/proc/self/cgroup", "/sys/fs/cgroup");
  return total <= 0
    ? Unlimited
    : static_cast<vtkTypeUInt64>(share * static_cast<double>(std::min(machine, group)));
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGCheckMemory(
  const std::string& what, double bytes, vtkTypeUInt64 property, const std::string& remedy)
{
  return dgg::CheckMemory(what, bytes, static_cast<double>(vtkDGGGetMemoryLimit(property)), remedy);
}
