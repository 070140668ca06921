// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point clouds as fields (x, y, z, intensity and so on, as in PCL and in PCD files), without VTK.
#ifndef dggPointFields_h
#define dggPointFields_h

#include <array>   // for the viewpoint
#include <cstddef> // for std::size_t
#include <cstdint> // for counts
#include <string>  // for names
#include <vector>  // for fields

namespace dgg
{
/// Description of the values that each point has.
struct PointField
{
  std::string Name; ///< as in PCL
  char Kind = 'F';  ///< kind of number: F (float), I (integer) or U (unsigned integer)
  int Size = 4;     ///< bytes of a number: 1, 2, 4 or 8
  int Count = 1;    ///< numbers per point

  /// Returns the bytes per point.
  std::size_t GetBytes() const
  {
    return static_cast<std::size_t>(this->Size) * static_cast<std::size_t>(this->Count);
  }
};

/// Memory of a field: the values of point i are at Data + i * Stride. They need no alignment.
struct PointFieldView
{
  PointField Field;           ///< description of the values
  const char* Data = nullptr; ///< values of point 0
  std::size_t Stride = 0;     ///< bytes from one point to the next
};

/// Position of a sensor: translation x, y, z, then quaternion w, x, y, z.
using Viewpoint = std::array<double, 7>;

/// Order of the points of a cloud, and its sensor.
struct CloudLayout
{
  std::int64_t Width = 0;  ///< points in a row
  std::int64_t Height = 1; ///< rows; 1 for a cloud without order
  /// Default: at the origin, without rotation
  Viewpoint Sensor = { { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 } };
};

/// A point cloud in memory, which it does not own.
struct PointCloudView : CloudLayout
{
  std::vector<PointFieldView> Fields; ///< fields, including x, y and z
};
}

/// Names for programs with VTK, see vtkDGGPointFields.h.
namespace vtkDGG
{
using dgg::PointCloudView;
using dgg::PointField;
using dgg::PointFieldView;
using dgg::Viewpoint;
}

#endif
