// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Numbers of any type, by kind and size. Internal to the fields of point clouds.
#ifndef vtkDGGPointNumbers_h
#define vtkDGGPointNumbers_h

#include <cstdint> // for the types

class vtkDataArray;

/// Names in the field data, and of fields that hold nothing.
constexpr const char* vtkDGGDimensionsName = "PCD.Dimensions";
constexpr const char* vtkDGGViewpointName = "PCD.Viewpoint";
constexpr const char* vtkDGGPaddingName = "_";

/// Call `worker` with a number of the type, as an example.
template <typename Worker>
void vtkDGGDispatchNumber(char kind, int size, const Worker& worker)
{
  const int type = kind == 'F' ? 0 : kind == 'I' ? 1 : 2;
  switch (16 * type + size)
  {
    case 4:
      return worker(float());
    case 8:
      return worker(double());
    case 16 + 1:
      return worker(std::int8_t());
    case 16 + 2:
      return worker(std::int16_t());
    case 16 + 4:
      return worker(std::int32_t());
    case 16 + 8:
      return worker(std::int64_t());
    case 32 + 1:
      return worker(std::uint8_t());
    case 32 + 2:
      return worker(std::uint16_t());
    case 32 + 4:
      return worker(std::uint32_t());
    case 32 + 8:
      return worker(std::uint64_t());
    default:
      break;
  }
}

/// The type of VTK's arrays for that kind and size.
int vtkDGGGetArrayType(char kind, int size);
/// The kind and size of the numbers of an array.
void vtkDGGGetArrayNumbers(vtkDataArray* array, char& kind, int& size);

#endif
// VTK-HeaderTest-Exclude: vtkDGGPointNumbers.h
