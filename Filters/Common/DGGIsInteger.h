// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Test for integer arrays of a given size, independent of VTK's type names. Internal.
#ifndef DGGIsInteger_h
#define DGGIsInteger_h

#include "vtkAbstractArray.h" // for the type
#include "vtkType.h"          // for its values

/// Returns true if the array contains signed integers of `size` bytes. VTK has several types of
/// 64-bit integers, and readers and NumPy use other types than vtkTypeInt64Array, so a cast is not
/// a sufficient test.
inline bool DGGIsInteger(vtkAbstractArray* array, int size)
{
  switch (array->GetDataType())
  {
    case VTK_INT:
    case VTK_LONG:
    case VTK_LONG_LONG:
    case VTK_ID_TYPE:
      return array->GetDataTypeSize() == size;
    default:
      return false;
  }
}

#endif
