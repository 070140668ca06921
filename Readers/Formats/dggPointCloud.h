// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Converts fields of point clouds to arrays and back. Internal to PCD files and to clouds of PCL.
#ifndef dggPointCloud_h
#define dggPointCloud_h

#include "dggMeshData.h"    // for arrays
#include "dggPointFields.h" // for fields

#include <memory> // for shared arrays
#include <string> // for messages
#include <vector> // for fields

namespace dgg
{
/// Name of fields that are skipped.
constexpr const char* PaddingName = "_";

/// Returns true if there are numbers of that kind and size.
bool IsFieldType(char kind, int size);

/// Returns the defect of the fields of a cloud, whose values may be missing; empty if there is
/// none.
std::string CheckPointFields(const PointCloudView& cloud);

/// Copies a cloud. Returns its defect; empty if there is none.
std::string ToMesh(const PointCloudView& cloud, MeshData& mesh);

/// Adds a vert for each point with finite coordinates.
void AddVertsOfFinitePoints(MeshData& mesh);

/// A field, and the components of the array that contains its values.
class FieldSource
{
public:
  /// For colors, all components of the array are bytes of one number.
  FieldSource(const PointField& field, std::shared_ptr<const DataArray> array, int firstComponent,
    bool isColor)
    : Field(field)
    , Array(std::move(array))
    , FirstComponent(static_cast<std::size_t>(firstComponent))
    , IsColor(isColor)
  {
  }

  const PointField& GetField() const { return this->Field; }
  /// Writes the values of the points [begin, end). The values of point i are written to destination
  /// + (i - begin) * stride as numbers of the given kind and size. Numbers out of range become the
  /// nearest number in range; NaN becomes 0 if the kind has no NaN.
  void Copy(std::size_t begin, std::size_t end, char kind, int size, char* destination,
    std::size_t stride) const;

private:
  PointField Field;
  std::shared_ptr<const DataArray> Array;
  std::size_t FirstComponent;
  bool IsColor;
};

/// Returns all fields of a mesh in the order x, y, z, normals, colors, other arrays. Unique names
/// have no blanks and differ from all others, also after they have become arrays. Otherwise names
/// are those of the arrays, and `rgb` and `rgba` replace each other.
std::vector<FieldSource> ListFields(MeshData&& mesh, bool areNamesUnique);
}

#endif
