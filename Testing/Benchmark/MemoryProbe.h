// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Peak memory of a piece of code. Linking this file replaces malloc() and its kin, so that every
/// peer is measured alike.
#ifndef MemoryProbe_h
#define MemoryProbe_h

#include <cstddef> // for std::size_t

/// Measures from construction on. One probe at a time, on one thread.
class MemoryProbe
{
public:
  MemoryProbe();
  /// Most bytes held in blocks of the allocator since construction, above those held then. 0 where
  /// its functions cannot be replaced (without glibc).
  std::size_t GetHeapPeak() const;
  /// Those held now, above those held then.
  std::size_t GetHeapGrowth() const;
  /// Growth of the resident set to its peak since construction, bytes: also counts what the
  /// allocator keeps, or takes in between blocks. 0 where the system does not show.
  std::size_t GetResidentPeak() const;

private:
  std::size_t HeapBefore;
  std::size_t ResidentBefore;
};

#endif
