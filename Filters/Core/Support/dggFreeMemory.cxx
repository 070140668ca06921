// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFreeMemory.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <sstream>

#ifdef _WIN32
#define NOMINMAX
#include <windows.h>
#else
#include <sys/resource.h>
#endif
#ifdef __APPLE__
#include <mach/mach.h>
#include <unistd.h>
#endif

namespace dgg
{
namespace
{
constexpr std::uint64_t Unlimited = std::numeric_limits<std::uint64_t>::max();

/// Returns the number after a key at the start of a line of a file, or the first number of the file
/// for an empty key; `missing` if there is none, such as for the value "max".
std::uint64_t Read(const std::string& path, const std::string& key, std::uint64_t missing)
{
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string name;
    std::uint64_t value = 0;
    if ((key.empty() || (words >> name && name == key)) && words >> value)
    {
      return value;
    }
  }
  return missing;
}

#ifdef _WIN32
/// Returns the bytes that the machine and the process leave free.
std::uint64_t GetFreeInMachine()
{
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof(status);
  return GlobalMemoryStatusEx(&status)
    ? std::min<std::uint64_t>(status.ullAvailPhys, status.ullAvailVirtual)
    : Unlimited;
}
#else
///@{
/// Returns the bytes that the machine leaves free, and the bytes that the process uses.
#ifdef __APPLE__
std::uint64_t GetAvailable()
{
  vm_statistics64_data_t pages;
  mach_msg_type_number_t count = HOST_VM_INFO64_COUNT;
  return host_statistics64(mach_host_self(), HOST_VM_INFO64,
           reinterpret_cast<host_info64_t>(&pages), &count) == KERN_SUCCESS
    ? (std::uint64_t{ pages.free_count } + pages.inactive_count) *
      static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE))
    : Unlimited;
}

std::uint64_t GetUsed()
{
  mach_task_basic_info_data_t task;
  mach_msg_type_number_t count = MACH_TASK_BASIC_INFO_COUNT;
  return task_info(mach_task_self(), MACH_TASK_BASIC_INFO, reinterpret_cast<task_info_t>(&task),
           &count) == KERN_SUCCESS
    ? task.resident_size
    : 0;
}
#else
std::uint64_t GetAvailable()
{
  const std::uint64_t kibibytes = Read("/proc/meminfo", "MemAvailable:", Unlimited);
  return kibibytes == Unlimited ? Unlimited : 1024 * kibibytes;
}

std::uint64_t GetUsed()
{
  return 1024 * Read("/proc/self/status", "VmRSS:", 0);
}
#endif
///@}

/// Returns the bytes that the machine and the limits of the process leave free.
std::uint64_t GetFreeInMachine()
{
  std::uint64_t free = GetAvailable();
  for (const auto resource : { RLIMIT_DATA, RLIMIT_AS })
  {
    rlimit limit{};
    if (getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    {
      const std::uint64_t used = GetUsed();
      free = std::min<std::uint64_t>(
        free, limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, used));
    }
  }
  return free;
}
#endif

/// Returns the default limit in bytes.
std::uint64_t FindAvailable()
{
  constexpr double share = 0.7;
  const std::uint64_t free =
    std::min(GetFreeInMachine(), GetFreeInControlGroup("/proc/self/cgroup", "/sys/fs/cgroup"));
  return free == Unlimited ? Unlimited
                           : static_cast<std::uint64_t>(share * static_cast<double>(free));
}
}

//------------------------------------------------------------------------------
std::uint64_t GetFreeInControlGroup(const std::string& membership, const std::string& mount)
{
  constexpr std::array<std::array<const char*, 5>, 2> versions{
    { { "", "0::", "max", "current", "inactive_file" },
      { "/memory", "memory", "limit_in_bytes", "usage_in_bytes", "total_inactive_file" } }
  };
  std::uint64_t free = Unlimited;
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
      const std::uint64_t limit = Read(files + limitName, "", Unlimited);
      const std::uint64_t used = Read(files + usageName, "", 0);
      const std::uint64_t reclaimable = std::min(used, Read(files + "stat", filesName, 0));
      free =
        limit == Unlimited ? free : std::min(free, limit - std::min(limit, used - reclaimable));
    }
  }
  return free;
}

//------------------------------------------------------------------------------
MemoryBudget MakeBudget(Offset property)
{
  return { static_cast<std::uint64_t>(property), &FindAvailable };
}
}
