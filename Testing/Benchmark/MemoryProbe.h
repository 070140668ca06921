// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Peak memory of a piece of code. Linking this file replaces the global operator new, so that
/// every peer is measured alike.
#ifndef MemoryProbe_h
#define MemoryProbe_h

#include <cstddef> // for std::size_t

/// Measures from construction on. One probe at a time, on one thread.
class MemoryProbe
{
public:
  MemoryProbe();
  /// Most bytes held through operator new since construction, above those held then. 0 where the
  /// size of an allocation is not known (outside Linux).
  std::size_t GetHeapPeak() const;
  /// Growth of the resident set to its peak since construction, bytes: also counts what is taken
  /// through malloc, as VTK's arrays do. 0 where the system does not tell.
  std::size_t GetResidentPeak() const;

private:
  std::size_t HeapBefore;
  std::size_t ResidentBefore;
};

#endif
