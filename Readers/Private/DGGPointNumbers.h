// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Numbers of any type, by kind and size. Internal to the fields of point clouds.
#ifndef DGGPointNumbers_h
#define DGGPointNumbers_h

#include "vtkSetGet.h" // for vtkTemplateMacro
#include "vtkType.h"   // for types

/// Names in the field data, and of fields that hold nothing.
constexpr const char* DGGDimensionsName = "PCD.Dimensions";
constexpr const char* DGGViewpointName = "PCD.Viewpoint";
constexpr const char* DGGPaddingName = "_";

/// The types of numbers that points have.
struct DGGNumberType
{
  char Kind;
  int Size;
  int ArrayType;
};
constexpr DGGNumberType DGGNumberTypes[] = { { 'F', 4, VTK_FLOAT }, { 'F', 8, VTK_DOUBLE },
  { 'I', 1, VTK_SIGNED_CHAR }, { 'U', 1, VTK_UNSIGNED_CHAR }, { 'I', 2, VTK_SHORT },
  { 'U', 2, VTK_UNSIGNED_SHORT }, { 'I', 4, VTK_INT }, { 'U', 4, VTK_UNSIGNED_INT },
  { 'I', 8, VTK_TYPE_INT64 }, { 'U', 8, VTK_TYPE_UINT64 } };

/// The type of VTK's arrays for that kind and size; VTK_VOID when there is none.
constexpr int DGGGetArrayType(char kind, int size)
{
  for (const DGGNumberType& type : DGGNumberTypes)
  {
    if (type.Kind == kind && type.Size == size)
    {
      return type.ArrayType;
    }
  }
  return VTK_VOID;
}

/// Call `worker` with a number of the type, as an example.
template <typename Worker>
void DGGDispatchNumber(int arrayType, const Worker& worker)
{
  switch (arrayType)
  {
    vtkTemplateMacro(worker(VTK_TT()));
    default:
      break;
  }
}

#endif
