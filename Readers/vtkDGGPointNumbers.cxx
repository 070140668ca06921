// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPointNumbers.h"

#include "vtkDataArray.h"
#include "vtkType.h"

#include <limits>

int vtkDGGGetArrayType(char kind, int size)
{
  const bool isSigned = kind == 'I';
  switch (kind == 'F' ? 10 * size : size)
  {
    case 1:
      return isSigned ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
    case 2:
      return isSigned ? VTK_SHORT : VTK_UNSIGNED_SHORT;
    case 4:
      return isSigned ? VTK_INT : VTK_UNSIGNED_INT;
    case 8:
      return isSigned ? VTK_TYPE_INT64 : VTK_TYPE_UINT64;
    case 40:
      return VTK_FLOAT;
    default:
      return VTK_DOUBLE;
  }
}

void vtkDGGGetArrayNumbers(vtkDataArray* array, char& kind, int& size)
{
  size = array->GetDataTypeSize();
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
    case VTK_DOUBLE:
      kind = 'F';
      return;
    case VTK_BIT:
      kind = 'U';
      size = 1;
      return;
    case VTK_CHAR:
      kind = std::numeric_limits<char>::is_signed ? 'I' : 'U';
      return;
    case VTK_UNSIGNED_CHAR:
    case VTK_UNSIGNED_SHORT:
    case VTK_UNSIGNED_INT:
    case VTK_UNSIGNED_LONG:
    case VTK_UNSIGNED_LONG_LONG:
      kind = 'U';
      return;
    default:
      kind = 'I';
      return;
  }
}
