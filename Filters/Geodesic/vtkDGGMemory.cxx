// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGMemory.h"

#include "vtkDGGControlGroup.h"

#include "dggMemoryLimit.h"

#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <limits>

namespace
{
constexpr double DefaultShare = 0.7;
constexpr vtkTypeUInt64 Unlimited = std::numeric_limits<vtkTypeUInt64>::max();

vtkTypeUInt64 Difference(long long total, long long used)
{
  return total > used ? static_cast<vtkTypeUInt64>(total - used) : 0;
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
  return std::min(1024 * std::min(machine, process),
    vtkDGGGetFreeInControlGroup("/proc/self/cgroup", "/sys/fs/cgroup"));
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
  return dgg::FormatBytes(bytes);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGCheckMemory(
  const std::string& what, double bytes, vtkTypeUInt64 property, const std::string& remedy)
{
  return dgg::CheckMemory(what, bytes, static_cast<double>(vtkDGGGetMemoryLimit(property)), remedy);
}
