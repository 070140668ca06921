// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Conversion of point clouds between fields (x, y, z, intensity and so on, as in PCL and in PCD
/// files) and vtkPolyData, for PCD files and for vtkDGGPointCloudConversions.h. Needs no PCL.
///
/// <b>Input and output</b>. Fields and arrays correspond as in vtkPCDReader and vtkPCDWriter: the
/// coordinates, `Normals`, `RGB` and `RGBA` by their meaning, all others by name, type and number
/// of components, bits as bytes. Points with finite coordinates have a vert. `PCD.Dimensions`
/// (width and height, int64) and `PCD.Viewpoint` (translation x, y, z and quaternion w, x, y, z of
/// the sensor, double) are field data; PCD.Dimensions is used if its product is the number of
/// points.
///
/// <b>Guarantee and cost</b>. Everything is copied; numbers keep their values and types.
///
/// <b>Errors</b>. For a malformed cloud the result is null and `error` is set. Arrays of strings
/// are skipped.
#ifndef vtkDGGPointFields_h
#define vtkDGGPointFields_h

#include "dggPointFields.h" // for fields

#include "vtkDGGReadersModule.h" // for the export macro
#include "vtkSmartPointer.h"     // for clouds
#include "vtkType.h"             // for vtkIdType

#include <cstddef> // for std::size_t
#include <memory>  // for the source
#include <string>  // for names
#include <vector>  // for fields

class vtkPolyData;

namespace vtkDGG
{
/// Returns a copy of the cloud. On error returns null, and `error` describes the defect.
VTKDGGREADERS_EXPORT vtkSmartPointer<vtkPolyData> MakePolyData(
  const PointCloudView& cloud, std::string& error);

/// A field, and its values in a vtkPolyData.
class VTKDGGREADERS_EXPORT PointFieldSource
{
public:
  class Values; ///< internal
  explicit PointFieldSource(std::shared_ptr<const Values> values);

  /// Returns the description of the values.
  const PointField& GetField() const;
  /// Writes the values of the points [begin, end). The values of point i are written to destination
  /// + (i - begin) * stride as numbers of the given kind and size. Numbers out of range become the
  /// nearest number in range; NaN becomes 0 if the kind has no NaN.
  void Copy(vtkIdType begin, vtkIdType end, char kind, int size, char* destination,
    std::size_t stride) const;

private:
  std::shared_ptr<const Values> Source;
};

/// Returns all fields of a vtkPolyData in the order x, y, z, normals, colors, other arrays. Arrays
/// that do not have a value for each point are skipped.
VTKDGGREADERS_EXPORT std::vector<PointFieldSource> ListPointFields(vtkPolyData* data);

/// Returns the sources for fields of these names, which are stored in `storage`; null where the
/// data have no array of that name and number of values. `rgb` and `rgba` may replace each other.
VTKDGGREADERS_EXPORT std::vector<const PointFieldSource*> FindPointFields(
  vtkPolyData* data, const std::vector<PointField>& fields, std::vector<PointFieldSource>& storage);

/// Reads width, height and viewpoint from the field data if they exist and fit; otherwise all
/// points are in one row, seen from the origin. Fields are unchanged.
VTKDGGREADERS_EXPORT void GetPointCloudLayout(vtkPolyData* data, PointCloudView& cloud);

/// Returns true if all coordinates are finite.
VTKDGGREADERS_EXPORT bool IsPointCloudDense(vtkPolyData* data);
}

#endif
