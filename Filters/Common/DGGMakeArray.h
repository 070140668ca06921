// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Arrays of outputs. Internal.
#ifndef DGGMakeArray_h
#define DGGMakeArray_h

#include "vtkFieldData.h"    // for where they go
#include "vtkSmartPointer.h" // for the arrays
#include "vtkType.h"         // for vtkIdType

#include <cstddef> // for std::size_t
#include <string>  // for names

/// An array with a name, to be filled.
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

/// The same, added to some data.
template <typename ArrayType>
vtkSmartPointer<ArrayType> DGGAddArray(
  vtkFieldData* data, const std::string& name, std::size_t tuples, int components = 1)
{
  auto array = DGGMakeArray<ArrayType>(name, tuples, components);
  data->AddArray(array);
  return array;
}

#endif
