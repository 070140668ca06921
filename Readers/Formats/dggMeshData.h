// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points, cells and arrays of a file, without VTK.
#ifndef dggMeshData_h
#define dggMeshData_h

#include "dggPointFields.h" // for the layout of clouds

#include <cstddef>  // for std::size_t
#include <cstdint>  // for types of numbers
#include <optional> // for the layout
#include <string>   // for names
#include <variant>  // for values of any type
#include <vector>   // for arrays

namespace dgg
{
/// Meaning of an array besides its values.
enum class ArrayRole
{
  None,
  Normals, ///< three components, float or double
  TCoords, ///< two components, float or double
  Colors   ///< three or four components (RGB, RGBA), std::uint8_t
};

using ArrayValues = std::variant<std::vector<float>, std::vector<double>, std::vector<std::int8_t>,
  std::vector<std::uint8_t>, std::vector<std::int16_t>, std::vector<std::uint16_t>,
  std::vector<std::int32_t>, std::vector<std::uint32_t>, std::vector<std::int64_t>,
  std::vector<std::uint64_t>>;

/// Numbers of one type, `Components` per point or cell.
struct DataArray
{
  std::string Name;
  int Components = 1;
  ArrayValues Values;
  ArrayRole Role = ArrayRole::None;
};

/// Cell i has the corners Connectivity[Offsets[i]] to Connectivity[Offsets[i + 1] - 1].
struct CellList
{
  std::vector<std::int64_t> Offsets = { 0 };
  std::vector<std::int64_t> Connectivity;

  std::size_t GetCount() const { return this->Offsets.size() - 1; }
  /// Ends the cell whose corners have been added to Connectivity.
  void EndCell() { this->Offsets.push_back(static_cast<std::int64_t>(this->Connectivity.size())); }
};

struct MeshData
{
  std::vector<double> Points;  ///< x, y, z of each point
  bool HasFloatPoints = false; ///< true if all coordinates are stored as float32
  CellList Verts;              ///< points, one corner each
  CellList Lines;              ///< polylines
  CellList Polygons;           ///< three corners or more
  std::vector<DataArray> PointArrays;
  std::vector<DataArray> CellArrays; ///< verts first, then lines, then polygons
  std::optional<CloudLayout> Layout; ///< layout of a point cloud in a PCD file
  std::vector<std::string> Warnings; ///< possible defects that are not errors

  std::size_t GetNumberOfPoints() const { return this->Points.size() / 3; }
};

/// Returns the array with the given role, or null.
inline const DataArray* FindArray(const std::vector<DataArray>& arrays, ArrayRole role)
{
  for (const DataArray& array : arrays)
  {
    if (array.Role == role)
    {
      return &array;
    }
  }
  return nullptr;
}
}

#endif
