// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Peak memory of a section of code. Linking this file replaces malloc() and related functions, so
/// that all peers are measured in the same manner.
#ifndef MemoryProbe_h
#define MemoryProbe_h

#include <cstddef> // for std::size_t

/// Measures from construction on. Only one probe may exist at a time, on one thread.
class MemoryProbe
{
public:
  MemoryProbe();
  /// Returns the peak of bytes in allocated blocks since construction, less the bytes at
  /// construction. 0 if the functions of the allocator cannot be replaced (without glibc).
  std::size_t GetHeapPeak() const;
  /// Returns the bytes in allocated blocks now, less the bytes at construction.
  std::size_t GetHeapGrowth() const;
  /// Returns the growth of the resident set to its peak since construction, in bytes. Includes
  /// memory that the allocator keeps, and its overhead between blocks. 0 if the system does not
  /// report it.
  std::size_t GetResidentPeak() const;

private:
  std::size_t HeapBefore;
  std::size_t ResidentBefore;
};

#endif
