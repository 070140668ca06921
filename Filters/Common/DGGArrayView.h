// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Converts an array of field data to the form of the kernel. Internal.
#ifndef DGGArrayView_h
#define DGGArrayView_h

#include "dggCounted.h"     // for the description
#include "dggStoredArray.h" // for StoredArray

#include "vtkAbstractArray.h" // for the array
#include "vtkType.h"          // for its type

/// Returns the kernel's type of an array. VTK has several types of 64-bit integers, and readers and
/// NumPy use other types than vtkTypeInt64Array, so a cast is not a sufficient test.
inline dgg::StoredArray::ValueType DGGGetValueType(vtkAbstractArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
      return dgg::StoredArray::Float;
    case VTK_DOUBLE:
      return dgg::StoredArray::Double;
    case VTK_INT:
    case VTK_LONG:
    case VTK_LONG_LONG:
    case VTK_ID_TYPE:
      return array->GetDataTypeSize() == 8 ? dgg::StoredArray::Int64 : dgg::StoredArray::Int32;
    default:
      return dgg::StoredArray::Other;
  }
}

/// Returns a view of an array, which may be null, with the given number of components.
inline dgg::StoredArray DGGViewArray(vtkAbstractArray* array, int components = 1)
{
  dgg::StoredArray stored;
  if (array)
  {
    // Any other layout would be copied by GetVoidPointer().
    const bool isContiguous = array->HasStandardMemoryLayout();
    stored.Type = isContiguous && array->GetNumberOfComponents() == components
      ? DGGGetValueType(array)
      : dgg::StoredArray::Other;
    stored.Data = isContiguous ? array->GetVoidPointer(0) : nullptr;
    stored.Size = array->GetNumberOfValues();
    stored.Description = std::string(array->GetDataTypeAsString()) + " with " +
      dgg::Counted(array->GetNumberOfComponents(), "component");
  }
  return stored;
}

#endif
