// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGControlGroup.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

namespace
{
constexpr vtkTypeUInt64 Unlimited = std::numeric_limits<vtkTypeUInt64>::max();

/// A number in a file; `Unlimited` when there is none, as in "max".
vtkTypeUInt64 ReadNumber(const std::string& path)
{
  std::ifstream file(path);
  vtkTypeUInt64 value = 0;
  return file >> value ? value : Unlimited;
}

/// The number behind a key in a file of "key number" lines; 0 when there is none.
vtkTypeUInt64 ReadKey(const std::string& path, const std::string& key)
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

/// Names of files in a group, which differ between the versions of control groups.
struct GroupFiles
{
  const char* Limit;
  const char* Usage;
  const char* Reclaimable; // pages of files, which are counted as used
};
constexpr GroupFiles FirstVersion = { "memory.limit_in_bytes", "memory.usage_in_bytes",
  "total_inactive_file" };
constexpr GroupFiles SecondVersion = { "memory.max", "memory.current", "inactive_file" };

vtkTypeUInt64 GetFreeInGroup(const std::string& folder, const GroupFiles& files)
{
  const vtkTypeUInt64 limit = ReadNumber(folder + "/" + files.Limit);
  const vtkTypeUInt64 used = ReadNumber(folder + "/" + files.Usage);
  if (limit == Unlimited || used == Unlimited)
  {
    return Unlimited;
  }
  const vtkTypeUInt64 reclaimable = ReadKey(folder + "/memory.stat", files.Reclaimable);
  const vtkTypeUInt64 kept = used - std::min(used, reclaimable);
  return limit - std::min(limit, kept);
}

/// The least of a group and all groups around it, up to the mounted root. Inside a container the
/// root often is the group of the container, and the path that of the machine: folders that do not
/// exist limit nothing.
vtkTypeUInt64 GetFreeUpwards(
  const std::string& root, const std::string& path, const GroupFiles& files)
{
  vtkTypeUInt64 free = GetFreeInGroup(root, files);
  const bool isInside = path.find("..") == std::string::npos;
  for (std::string group = isInside ? path : ""; group.size() > 1;
       group.resize(group.find_last_of('/')))
  {
    free = std::min(free, GetFreeInGroup(root + group, files));
  }
  return free;
}

bool HasMemoryController(const std::string& controllers)
{
  std::istringstream list(controllers);
  for (std::string name; std::getline(list, name, ',');)
  {
    if (name == "memory")
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDGGGetFreeInControlGroup(const std::string& membership, const std::string& mount)
{
  // At least the root, also where the groups of the process are not known.
  vtkTypeUInt64 free = std::min(
    GetFreeUpwards(mount, "", SecondVersion), GetFreeUpwards(mount + "/memory", "", FirstVersion));
  std::ifstream file(membership);
  for (std::string line; std::getline(file, line);)
  {
    // "number:controllers:/path"; the second version has the number 0 and names no controllers.
    std::istringstream fields(line);
    std::string number;
    std::string controllers;
    std::string path;
    std::getline(fields, number, ':');
    std::getline(fields, controllers, ':');
    std::getline(fields, path);
    if (path.empty() || path[0] != '/')
    {
      continue;
    }
    if (HasMemoryController(controllers))
    {
      free = std::min(free, GetFreeUpwards(mount + "/memory", path, FirstVersion));
    }
    else if (number == "0" && controllers.empty())
    {
      free = std::min(free, GetFreeUpwards(mount, path, SecondVersion));
      free = std::min(free, GetFreeUpwards(mount + "/unified", path, SecondVersion));
    }
  }
  return free;
}
