// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMemoryLimit.h"

#include <array>
#include <cstddef>
#include <cstdio>

namespace dgg
{
std::string FormatBytes(double bytes)
{
  constexpr std::array<const char*, 5> units{ { "bytes", "KiB", "MiB", "GiB", "TiB" } };
  std::size_t unit = 0;
  while (bytes >= 1024.0 && unit + 1 < units.size())
  {
    bytes /= 1024.0;
    ++unit;
  }
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.4g %s", bytes, units[unit]);
  return text.data();
}

Status CheckMemory(const std::string& what, double bytes, double limit, const std::string& remedy)
{
  return bytes <= limit ? Status::Success()
                        : Status(Status::Code::OutOfMemory,
                            what + " needs about " + FormatBytes(bytes) +
                              ", more than the limit of " + FormatBytes(limit))
                            .At("MemoryLimit")
                            .Fix(remedy, ", or raise {MemoryLimit}");
}

double MemoryBudget::GetBytes() const
{
  return this->IsExplicit() ? static_cast<double>(this->Limit)
    : this->FindAvailable   ? static_cast<double>(this->FindAvailable())
                            : Infinity;
}
}
