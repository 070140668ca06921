// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point clouds as fields (x, y, z, intensity and so on, as in PCL and in PCD files), to and from
/// vtkPolyData. PCD files and vtkDGGPointCloudConversions.h share this; it needs no PCL.
///
/// <b>Input and output</b>. Fields and arrays correspond as in vtkPCDReader and vtkPCDWriter: the
/// coordinates, `Normals`, `RGB` and `RGBA` by their meaning, all others by name, type and number
/// of components, bits as bytes. Points with finite coordinates have a vert. `PCD.Dimensions`
/// (width and height, int64) and `PCD.Viewpoint` (translation x, y, z and quaternion w, x, y, z of
/// the sensor, double) are field data; the former counts if the product is the number of points.
///
/// <b>Guarantee and cost</b>. Everything is copied; numbers keep their values and types.
///
/// <b>Errors</b>. Malformed clouds give null and a message. Arrays of strings are left out.
#ifndef vtkDGGPointFields_h
#define vtkDGGPointFields_h

#include "vtkDGGReadersModule.h" // for the export macro
#include "vtkSmartPointer.h"     // for the array of a source
#include "vtkType.h"             // for vtkIdType

#include <array>   // for the viewpoint
#include <cstddef> // for std::size_t
#include <string>  // for names
#include <vector>  // for fields

class vtkDataArray;
class vtkPolyData;

namespace vtkDGG
{
/// A number of values that each point has.
struct PointField
{
  std::string Name; ///< as in PCL
  char Kind = 'F';  ///< of number: F (float), I (integer) or U (unsigned integer)
  int Size = 4;     ///< bytes of a number: 1, 2, 4 or 8
  int Count = 1;    ///< numbers per point

  /// Bytes per point.
  std::size_t GetBytes() const
  {
    return static_cast<std::size_t>(this->Size) * static_cast<std::size_t>(this->Count);
  }
};

/// Whether there are numbers of that kind and size.
VTKDGGREADERS_EXPORT bool IsPointFieldType(char kind, int size);

/// Where the values of a field are: point i has them at Data + i * Stride. They need no alignment.
struct PointFieldView
{
  PointField Field;           ///< what the values are
  const char* Data = nullptr; ///< those of point 0
  std::size_t Stride = 0;     ///< bytes from one point to the next
};

/// Position of a sensor: translation x, y, z, then quaternion w, x, y, z.
using Viewpoint = std::array<double, 7>;

/// A point cloud in memory, which it does not own.
struct PointCloudView
{
  std::vector<PointFieldView> Fields; ///< those of x, y and z among them
  vtkIdType Width = 0;                ///< points in a row
  vtkIdType Height = 1;               ///< rows; 1 for a cloud without order
  Viewpoint Sensor = { { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 } }; ///< where the scanner was
};

/// What is wrong with the fields of a cloud, whose values may be missing; empty when all is well.
VTKDGGREADERS_EXPORT std::string CheckPointFields(const PointCloudView& cloud);

/// A copy of the cloud. Nothing on error, when `error` says what is wrong.
VTKDGGREADERS_EXPORT vtkSmartPointer<vtkPolyData> MakePolyData(
  const PointCloudView& cloud, std::string& error);

/// Where in a vtkPolyData the values of a field come from.
class VTKDGGREADERS_EXPORT PointFieldSource
{
public:
  /// From components of an array, the first one being firstComponent; isColor for colours, of
  /// which all components are bytes of one number.
  PointFieldSource(const PointField& field, vtkDataArray* array, int firstComponent, bool isColor);

  /// What the values are.
  const PointField& GetField() const { return this->Field; }
  /// Write the values of the points [begin, end): those of point i to
  /// destination + (i - begin) * stride, as numbers of that kind and size. Numbers out of range
  /// become the nearest ones in it, and NaN becomes 0 where there is none.
  void Copy(vtkIdType begin, vtkIdType end, char kind, int size, char* destination,
    std::size_t stride) const;

private:
  PointField Field;
  vtkSmartPointer<vtkDataArray> Array; // of the numbers of the field, in the order of points
  int FirstComponent = 0;
  bool IsColor = false;
};

/// All fields of a vtkPolyData, in the order x, y, z, normals, colours, other arrays. Arrays that
/// do not have a value for each point are left out.
VTKDGGREADERS_EXPORT std::vector<PointFieldSource> ListPointFields(vtkPolyData* data);

/// The sources for fields of these names, null where the data have nothing of that name and number
/// of values; `rgb` and `rgba` may replace each other. The sources lie in `storage`.
VTKDGGREADERS_EXPORT std::vector<const PointFieldSource*> FindPointFields(
  vtkPolyData* data, const std::vector<PointField>& wanted, std::vector<PointFieldSource>& storage);

/// Width, height and viewpoint in the field data, as far as they are there and fit; otherwise all
/// points in one row, seen from the origin. Fields are left alone.
VTKDGGREADERS_EXPORT void GetPointCloudLayout(vtkPolyData* data, PointCloudView& cloud);

/// Whether all coordinates are finite.
VTKDGGREADERS_EXPORT bool IsPointCloudDense(vtkPolyData* data);
}

#endif
