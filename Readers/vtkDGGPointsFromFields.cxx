// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPointFields.h"

#include "vtkDGGPointNumbers.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>

namespace
{
using vtkDGG::PointCloudView;
using vtkDGG::PointField;
using vtkDGG::PointFieldView;

/// Whether three fields have numbers of one type.
bool HaveSameType(const PointFieldView* const* views)
{
  return std::all_of(views + 1, views + 3, [views](const PointFieldView* view) {
    return view->Field.Kind == views[0]->Field.Kind && view->Field.Size == views[0]->Field.Size;
  });
}

/// The fields of a cloud by their meaning.
class FieldTable
{
public:
  /// False, with the reason, when the fields make no cloud, or two of them the same array.
  bool Fill(const PointCloudView& cloud, std::string& error)
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
      const std::string name(1, "xyz"[c]);
      if (!this->Coordinates[c])
      {
        error = "there is no field '" + name + "': a point cloud needs the fields x, y and z";
        return false;
      }
      if (this->Coordinates[c]->Field.Count != 1)
      {
        error = "the field '" + name + "' has " +
          std::to_string(this->Coordinates[c]->Field.Count) + " values per point, expected one";
        return false;
      }
    }
    this->HasNormals = std::all_of(this->Normals, this->Normals + 3,
                         [](const PointFieldView* view) {
                           return view && view->Field.Count == 1 && view->Field.Kind == 'F';
                         }) &&
      HaveSameType(this->Normals);
    for (const PointFieldView* view : this->Normals)
    {
      if (view && !this->HasNormals)
      {
        this->Others.push_back(view); // not a vector, so a field like others
      }
    }
    return this->CheckName(this->HasNormals, "Normals", "normal_x, normal_y, normal_z", error) &&
      this->CheckName(this->Color != nullptr, "RGB", "rgb", error) &&
      this->CheckName(this->ColorWithAlpha != nullptr, "RGBA", "rgba", error);
  }

  const PointFieldView* Coordinates[3] = { nullptr, nullptr, nullptr };
  const PointFieldView* Normals[3] = { nullptr, nullptr, nullptr };
  const PointFieldView* Color = nullptr;
  const PointFieldView* ColorWithAlpha = nullptr;
  std::vector<const PointFieldView*> Others;
  bool HasNormals = false;

private:
  void Place(const PointFieldView& view)
  {
    const std::string& name = view.Field.Name;
    const bool isPacked = view.Field.GetBytes() == 4 && view.Field.Count == 1;
    for (int c = 0; c < 3; ++c)
    {
      if (name == std::string(1, "xyz"[c]))
      {
        this->Coordinates[c] = &view;
        return;
      }
      if (name == std::string("normal_") + "xyz"[c])
      {
        this->Normals[c] = &view;
        return;
      }
    }
    if (isPacked && (name == "rgb" || name == "rgba"))
    {
      (name == "rgb" ? this->Color : this->ColorWithAlpha) = &view;
    }
    else if (name != vtkDGGPaddingName)
    {
      this->Others.push_back(&view);
    }
  }

  /// Arrays of one name would replace each other.
  bool CheckName(bool isMade, const char* array, const char* fields, std::string& error) const
  {
    if (isMade && this->Names.count(array) > 0)
    {
      error = std::string("the fields ") + fields + " and '" + array +
        "' would both become the array " + array;
      return false;
    }
    return true;
  }

  std::set<std::string> Names;
};

double GetNumber(const PointField& field, const char* data)
{
  double number = 0.0;
  vtkDGGDispatchNumber(field.Kind, field.Size, [data, &number](auto example) {
    std::memcpy(&example, data, sizeof(example));
    number = static_cast<double>(example);
  });
  return number;
}

/// Fields of one type and number of values, one after the other, as the components of an array.
vtkSmartPointer<vtkDataArray> Join(const PointFieldView* const* views, int fields, vtkIdType count)
{
  const PointField& first = views[0]->Field;
  auto array = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(vtkDGGGetArrayType(first.Kind, first.Size)));
  array->SetNumberOfComponents(fields * first.Count);
  array->SetNumberOfTuples(count);
  const std::size_t bytes = first.GetBytes();
  for (int f = 0; f < fields && count > 0; ++f)
  {
    char* out = static_cast<char*>(array->GetVoidPointer(0)) + static_cast<std::size_t>(f) * bytes;
    const char* in = views[f]->Data;
    for (vtkIdType i = 0; i < count; ++i, in += views[f]->Stride)
    {
      std::memcpy(out, in, bytes);
      out += static_cast<std::size_t>(fields) * bytes;
    }
  }
  return array;
}

vtkSmartPointer<vtkDataArray> MakeCoordinates(const PointFieldView* const* views, vtkIdType count)
{
  if (views[0]->Field.Kind == 'F' && HaveSameType(views))
  {
    return Join(views, 3, count);
  }
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(count);
  for (int c = 0; c < 3; ++c)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      const char* data = views[c]->Data + static_cast<std::size_t>(i) * views[c]->Stride;
      array->SetTypedComponent(i, c, GetNumber(views[c]->Field, data));
    }
  }
  return array;
}

/// Colours lie in the bytes of a number: alpha, red, green, blue, from the most significant one on.
vtkSmartPointer<vtkDataArray> MakeColors(
  const PointFieldView& view, int components, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName(components == 4 ? "RGBA" : "RGB");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  unsigned char* out = array->GetPointer(0);
  const char* in = view.Data;
  for (vtkIdType i = 0; i < count; ++i, in += view.Stride, out += components)
  {
    std::uint32_t packed = 0;
    std::memcpy(&packed, in, 4);
    out[0] = static_cast<unsigned char>(packed >> 16);
    out[1] = static_cast<unsigned char>(packed >> 8);
    out[2] = static_cast<unsigned char>(packed);
    if (components == 4)
    {
      out[3] = static_cast<unsigned char>(packed >> 24);
    }
  }
  return array;
}

/// One vertex for each point that has a place.
template <typename Ids>
vtkSmartPointer<vtkCellArray> MakeVertices(vtkDataArray* coordinates)
{
  const vtkIdType count = coordinates->GetNumberOfTuples();
  vtkNew<Ids> points;
  points->SetNumberOfValues(count);
  vtkIdType used = 0;
  double p[3];
  for (vtkIdType i = 0; i < count; ++i)
  {
    coordinates->GetTuple(i, p);
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
    {
      points->SetValue(used++, static_cast<typename Ids::ValueType>(i));
    }
  }
  points->Resize(used);
  points->SetNumberOfValues(used);
  vtkNew<Ids> offsets;
  offsets->SetNumberOfValues(used + 1);
  for (vtkIdType i = 0; i <= used; ++i)
  {
    offsets->SetValue(i, static_cast<typename Ids::ValueType>(i));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, points);
  return cells;
}
}

vtkSmartPointer<vtkPolyData> vtkDGG::MakePolyData(const PointCloudView& cloud, std::string& error)
{
  FieldTable table;
  if (!table.Fill(cloud, error))
  {
    return nullptr;
  }
  if (cloud.Width < 0 || cloud.Height < 0 ||
    (cloud.Height > 0 && cloud.Width > VTK_ID_MAX / cloud.Height))
  {
    error = "the width or the height is out of range";
    return nullptr;
  }
  const vtkIdType count = cloud.Width * cloud.Height;
  auto output = vtkSmartPointer<vtkPolyData>::New();
  vtkSmartPointer<vtkDataArray> coordinates = MakeCoordinates(table.Coordinates, count);
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);
  output->SetVerts(count < std::numeric_limits<std::int32_t>::max()
      ? MakeVertices<vtkTypeInt32Array>(coordinates)
      : MakeVertices<vtkTypeInt64Array>(coordinates));

  vtkPointData* data = output->GetPointData();
  if (table.HasNormals)
  {
    vtkSmartPointer<vtkDataArray> normals = Join(table.Normals, 3, count);
    normals->SetName("Normals");
    data->SetNormals(normals);
  }
  if (table.ColorWithAlpha)
  {
    data->SetScalars(MakeColors(*table.ColorWithAlpha, 4, count));
  }
  if (table.Color)
  {
    vtkSmartPointer<vtkDataArray> colors = MakeColors(*table.Color, 3, count);
    data->AddArray(colors);
    data->SetActiveScalars(colors->GetName());
  }
  for (const PointFieldView* view : table.Others)
  {
    vtkSmartPointer<vtkDataArray> array = Join(&view, 1, count);
    array->SetName(view->Field.Name.c_str());
    data->AddArray(array);
  }

  vtkNew<vtkTypeInt64Array> dimensions;
  dimensions->SetName(vtkDGGDimensionsName);
  dimensions->InsertNextValue(cloud.Width);
  dimensions->InsertNextValue(cloud.Height);
  output->GetFieldData()->AddArray(dimensions);
  vtkNew<vtkDoubleArray> viewpoint;
  viewpoint->SetName(vtkDGGViewpointName);
  for (const double value : cloud.Sensor)
  {
    viewpoint->InsertNextValue(value);
  }
  output->GetFieldData()->AddArray(viewpoint);
  return output;
}
