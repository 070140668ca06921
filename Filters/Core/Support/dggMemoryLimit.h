// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The memory limit of an update, and the error when it is exceeded. Internal.
#ifndef dggMemoryLimit_h
#define dggMemoryLimit_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggStatus.h"     // for Status

#include <cstdint> // for bytes
#include <string>  // for messages

namespace dgg
{
/// Returns text such as "1.53 GiB".
DGG_CORE_EXPORT std::string FormatBytes(double bytes);

/// Fails if `bytes`, which `what` needs, exceed the limit, the property MemoryLimit of filters.
/// `remedy` is the action besides raising the limit.
DGG_CORE_EXPORT Status CheckMemory(
  const std::string& what, double bytes, double limit, const std::string& remedy);

/// The memory that an update may take.
struct DGG_CORE_EXPORT MemoryBudget
{
  std::uint64_t Limit = 0;                    ///< bytes; 0 for a share of the free memory
  std::uint64_t (*FindAvailable)() = nullptr; ///< returns that share; null: unlimited

  bool IsExplicit() const { return this->Limit > 0; }
  /// Returns the limit in bytes at this time.
  double GetBytes() const;
  /// Fails if `bytes` exceed the limit. See CheckMemory().
  Status Check(const std::string& what, double bytes, const std::string& remedy) const
  {
    return CheckMemory(what, bytes, this->GetBytes(), remedy);
  }
};
}

#endif
