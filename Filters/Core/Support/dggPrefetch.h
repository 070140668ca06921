// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Prefetching of memory. Internal.
#ifndef dggPrefetch_h
#define dggPrefetch_h

namespace dgg
{
/// Hints that the memory at an address will soon be read. Any address is allowed.
inline void Prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
  // GCC considers a function that only prefetches to have no effect and removes the call.
  __asm__ volatile("" : : "r"(address));
#else
  static_cast<void>(address);
#endif
}
}

#endif
