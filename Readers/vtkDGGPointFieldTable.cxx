// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPointFieldTable.h"

#include "vtkDGGPointNumbers.h"

#include <algorithm>
#include <iterator>

using vtkDGG::PointCloudView;
using vtkDGG::PointField;
using vtkDGG::PointFieldView;

bool vtkDGGHaveSameType(const PointFieldView* const* views)
{
  return std::all_of(views + 1, views + 3, [views](const PointFieldView* view) {
    return view->Field.Kind == views[0]->Field.Kind && view->Field.Size == views[0]->Field.Size;
  });
}

bool vtkDGGPointFieldTable::Fill(const PointCloudView& cloud, std::string& error)
{
  for (const PointFieldView& view : cloud.Fields)
  {
    const std::string& name = view.Field.Name;
    if (!vtkDGG::IsPointFieldType(view.Field.Kind, view.Field.Size) || view.Field.Count < 1)
    {
      error = "the field '" + name + "' has numbers of no known type, or none";
      return false;
    }
    if (name != vtkDGGPaddingName && !this->Names.insert(name).second)
    {
      error = "there are two fields '" + name + "'";
      return false;
    }
    this->Place(view);
  }
  for (int c = 0; c < 3; ++c)
  {
    const char* const names[] = { "x", "y", "z" };
    if (!this->Coordinates[c])
    {
      error = std::string("there is no field '") + names[c] +
        "': a point cloud needs the fields x, y and z";
      return false;
    }
    if (this->Coordinates[c]->Field.Count != 1)
    {
      error = std::string("the field '") + names[c] + "' has " +
        std::to_string(this->Coordinates[c]->Field.Count) + " values per point, expected one";
      return false;
    }
  }
  const auto isNormal = [](const PointFieldView* view) {
    return view && view->Field.Count == 1 && view->Field.Kind == 'F';
  };
  this->HasNormals =
    std::all_of(this->Normals, this->Normals + 3, isNormal) && vtkDGGHaveSameType(this->Normals);
  if (!this->HasNormals)
  {
    // Not a vector, so they are fields like others.
    std::copy_if(this->Normals, this->Normals + 3, std::back_inserter(this->Others),
      [](const PointFieldView* view) { return view != nullptr; });
  }
  return this->CheckNames(error);
}

void vtkDGGPointFieldTable::Place(const PointFieldView& view)
{
  const PointField& field = view.Field;
  const bool isPacked = field.GetBytes() == 4 && field.Count == 1;
  for (int c = 0; c < 3; ++c)
  {
    if (field.Name == std::string(1, "xyz"[c]))
    {
      this->Coordinates[c] = &view;
      return;
    }
    if (field.Name == std::string("normal_") + "xyz"[c])
    {
      this->Normals[c] = &view;
      return;
    }
  }
  if (field.Name == "rgb" && isPacked)
  {
    this->Color = &view;
  }
  else if (field.Name == "rgba" && isPacked)
  {
    this->ColorWithAlpha = &view;
  }
  else if (field.Name != vtkDGGPaddingName)
  {
    this->Others.push_back(&view);
  }
}

bool vtkDGGPointFieldTable::CheckNames(std::string& error) const
{
  const struct
  {
    bool Used;
    const char* Array;
    const char* Fields;
  } made[] = { { this->HasNormals, "Normals", "normal_x, normal_y, normal_z" },
    { this->Color != nullptr, "RGB", "rgb" }, { this->ColorWithAlpha != nullptr, "RGBA", "rgba" } };
  for (const auto& array : made)
  {
    if (array.Used && this->Names.count(array.Array) > 0)
    {
      error = std::string("the fields ") + array.Fields + " and '" + array.Array +
        "' would both become the array " + array.Array;
      return false;
    }
  }
  return true;
}
