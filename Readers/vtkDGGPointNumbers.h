// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Numbers of any type, by kind and size. Internal to the fields of point clouds.
#ifndef vtkDGGPointNumbers_h
#define vtkDGGPointNumbers_h

#include "vtkDataArray.h" // for the type of an array
#include "vtkSetGet.h"    // for vtkTemplateMacro
#include "vtkType.h"      // for types

#include <limits> // for char

/// Names in the field data, and of fields that hold nothing.
constexpr const char* vtkDGGDimensionsName = "PCD.Dimensions";
constexpr const char* vtkDGGViewpointName = "PCD.Viewpoint";
constexpr const char* vtkDGGPaddingName = "_";

/// The type of VTK's arrays for that kind and size.
inline int vtkDGGGetArrayType(char kind, int size)
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

/// The kind and size of the numbers of an array.
inline void vtkDGGGetArrayNumbers(vtkDataArray* array, char& kind, int& size)
{
  kind = 'I';
  size = array->GetDataTypeSize();
  const int type = array->GetDataType();
  if (type == VTK_BIT)
  {
    kind = 'U';
    size = 1;
    return;
  }
  switch (type)
  {
    vtkTemplateMacro(kind = !std::numeric_limits<VTK_TT>::is_integer ? 'F'
        : std::numeric_limits<VTK_TT>::is_signed                     ? 'I'
                                                                     : 'U');
    default:
      break;
  }
}

/// Call `worker` with a number of the type, as an example.
template <typename Worker>
void vtkDGGDispatchNumber(char kind, int size, const Worker& worker)
{
  switch (vtkDGGGetArrayType(kind, size))
  {
    vtkTemplateMacro(worker(VTK_TT()));
    default:
      break;
  }
}

#endif
// VTK-HeaderTest-Exclude: vtkDGGPointNumbers.h
