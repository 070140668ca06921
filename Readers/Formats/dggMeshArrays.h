// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Arrays of a mesh in terms of front ends: active arrays, and the layout of a cloud as arrays.
#ifndef dggMeshArrays_h
#define dggMeshArrays_h

#include "dggMeshData.h"

#include <vector> // for arrays

namespace dgg
{
///@{
/// Names of the arrays that contain the layout of a point cloud.
constexpr const char* DimensionsName = "PCD.Dimensions";
constexpr const char* ViewpointName = "PCD.Viewpoint";
///@}

/// Indices of active arrays; -1 for none.
struct ActiveArrays
{
  int Normals = -1;
  int TCoords = -1;
  int Scalars = -1;
};

/// Finds normals, texture coordinates and colors, sets their roles and moves them to the front.
/// Colors are named `RGB` or `RGBA`, or are the active scalars.
void SetRoles(std::vector<DataArray>& arrays, const ActiveArrays& active);

/// Returns width and height, and the viewpoint, as two arrays.
std::vector<DataArray> MakeLayoutArrays(const CloudLayout& layout);

/// Returns the layout of `count` points. Dimensions or a viewpoint that do not fit are ignored.
CloudLayout ReadLayout(
  std::size_t count, const std::vector<double>& dimensions, const std::vector<double>& viewpoint);
}

#endif
