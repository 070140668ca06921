// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Arrays in field data and in files. Internal.
#ifndef dggStoredArray_h
#define dggStoredArray_h

#include "dggTypes.h" // for Offset

#include <string> // for messages

namespace dgg
{
/// An array of a stored graph or of stored windows.
struct StoredArray
{
  enum ValueType
  {
    Missing,
    Int32,
    Int64,
    Float,
    Double,
    Other ///< another type or number of components, or not contiguous in memory
  };

  const void* Data = nullptr;
  Offset Size = 0; ///< number of values
  ValueType Type = Missing;
  std::string Description; ///< type and number of components, for messages

  template <typename Value>
  const Value* GetValues() const
  {
    return static_cast<const Value*>(this->Data);
  }
};
}

#endif
