// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The fields of a cloud by their meaning. Internal to the fields of point clouds.
#ifndef vtkDGGPointFieldTable_h
#define vtkDGGPointFieldTable_h

#include "vtkDGGPointFields.h" // for clouds and fields

#include <set>    // for the names
#include <string> // for messages
#include <vector> // for the fields

class vtkDGGPointFieldTable
{
public:
  /// False, with the reason, when the fields make no cloud, or two of them the same array.
  bool Fill(const vtkDGG::PointCloudView& cloud, std::string& error);

  const vtkDGG::PointFieldView* Coordinates[3] = { nullptr, nullptr, nullptr };
  const vtkDGG::PointFieldView* Normals[3] = { nullptr, nullptr, nullptr };
  const vtkDGG::PointFieldView* Color = nullptr;
  const vtkDGG::PointFieldView* ColorWithAlpha = nullptr;
  std::vector<const vtkDGG::PointFieldView*> Others;
  bool HasNormals = false;

private:
  void Place(const vtkDGG::PointFieldView& view);
  /// Arrays of one name would replace each other.
  bool CheckNames(std::string& error) const;

  std::set<std::string> Names;
};

/// Whether three fields have numbers of one type.
bool vtkDGGHaveSameType(const vtkDGG::PointFieldView* const* views);

#endif
// VTK-HeaderTest-Exclude: vtkDGGPointFieldTable.h
