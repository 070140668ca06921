// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Large pages of memory. Internal.
#ifndef dggLargePages_h
#define dggLargePages_h

#include <cstddef> // for std::size_t
#include <vector>  // for the arrays

namespace dgg
{
/// Asks the system for large pages behind an array that has not been written yet. Scattered reads
/// of large arrays take less time with them. Does nothing for small arrays and where the system has
/// no such request.
void UseLargePages(void* begin, std::size_t size);

/// Resizes an array and sets all entries. New memory has large pages if possible.
template <typename Value>
void AssignInLargePages(std::vector<Value>& values, std::size_t size, const Value& value)
{
  if (values.capacity() < size)
  {
    std::vector<Value>().swap(values);
    values.reserve(size);
    UseLargePages(values.data(), size * sizeof(Value));
  }
  values.assign(size, value);
}
}

#endif
