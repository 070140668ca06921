// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Creates arrays of outputs. Internal.
#ifndef DGGMakeArray_h
#define DGGMakeArray_h

#include "dggBuffer.h" // for Buffer

#include "vtkFieldData.h"    // for where they go
#include "vtkSmartPointer.h" // for the arrays
#include "vtkType.h"         // for vtkIdType

#include <cstddef> // for std::size_t
#include <string>  // for names

/// Returns an array with a name and uninitialized values.
template <typename ArrayType>
vtkSmartPointer<ArrayType> DGGMakeArray(
  const std::string& name, std::size_t tuples, int components = 1)
{
  auto array = vtkSmartPointer<ArrayType>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

/// Returns an array that takes over the memory of a buffer.
template <typename ArrayType, typename ValueType>
vtkSmartPointer<ArrayType> DGGAdoptArray(
  dgg::Buffer<ValueType>& buffer, const char* name, int components = 1)
{
  static_assert(sizeof(typename ArrayType::ValueType) == sizeof(ValueType), "another size");
  auto array = vtkSmartPointer<ArrayType>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  const auto size = static_cast<vtkIdType>(buffer.Size());
  if (size > 0)
  {
    // VTK has two types for 64-bit integers; the values have the same layout.
    auto* values = reinterpret_cast<typename ArrayType::ValueType*>(buffer.Release());
    array->SetArray(values, size, 0, ArrayType::VTK_DATA_ARRAY_FREE);
  }
  return array;
}

/// Like DGGMakeArray(), but also adds the array to `data`.
template <typename ArrayType>
vtkSmartPointer<ArrayType> DGGAddArray(
  vtkFieldData* data, const std::string& name, std::size_t tuples, int components = 1)
{
  auto array = DGGMakeArray<ArrayType>(name, tuples, components);
  data->AddArray(array);
  return array;
}

#endif
