// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is said when something would take more memory than it may. Internal.
#ifndef dggMemoryLimit_h
#define dggMemoryLimit_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggTypes.h"      // for Status

#include <string> // for messages

namespace dgg
{
/// "1.53 GiB"
DGG_CORE_EXPORT std::string FormatBytes(double bytes);

/// Fails when `bytes` are more than the limit, which users know as the property MemoryLimit. `what`
/// would take them; `remedy` is what to do besides raising it.
DGG_CORE_EXPORT Status CheckMemory(
  const std::string& what, double bytes, double limit, const std::string& remedy);
}

#endif
