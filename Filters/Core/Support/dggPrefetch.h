// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Asks for memory ahead of its use. Internal.
#ifndef dggPrefetch_h
#define dggPrefetch_h

namespace dgg
{
/// A hint that the memory at an address will soon be read. Any address is allowed.
inline void Prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
  // GCC takes a function that does nothing but prefetch for one without effect and drops the call.
  __asm__ volatile("" : : "r"(address));
#else
  static_cast<void>(address);
#endif
}
}

#endif
