// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Integers of a size, whatever VTK calls them. Internal.
#ifndef DGGIsInteger_h
#define DGGIsInteger_h

#include "vtkAbstractArray.h" // for the type
#include "vtkType.h"          // for its values

/// Whether an array is of signed integers of so many bytes. 64-bit integers have several names:
/// readers and NumPy use others than vtkTypeInt64Array, so that a cast is no test.
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
