// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPointFields.h"

#include "DGGPointNumbers.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>

namespace
{
using vtkDGG::PointCloudView;
using vtkDGG::PointFieldView;
using Vector = std::array<const PointFieldView*, 3>;

/// The fields of a cloud by their names.
struct FieldTable
{
  std::map<std::string, const PointFieldView*> Views;

  /// Null when there is none.
  const PointFieldView* Find(const std::string& name) const
  {
    const auto view = this->Views.find(name);
    return view == this->Views.end() ? nullptr : view->second;
  }
  Vector FindVector(const std::string& prefix) const
  {
    return { { this->Find(prefix + "x"), this->Find(prefix + "y"), this->Find(prefix + "z") } };
  }
  /// All or none.
  Vector FindNormals() const
  {
    const Vector views = this->FindVector("normal_");
    const bool isVector = std::all_of(views.begin(), views.end(), [&](const PointFieldView* view) {
      return view && view->Field.Count == 1 && view->Field.Kind == 'F' &&
        view->Field.Size == views[0]->Field.Size;
    });
    return isVector ? views : Vector();
  }
  const PointFieldView* FindColor(const char* name) const
  {
    const PointFieldView* view = this->Find(name);
    return view && view->Field.Size == 4 && view->Field.Count == 1 ? view : nullptr;
  }
};

/// Fields of one type and number of values, one after the other, as the components of an array.
vtkSmartPointer<vtkDataArray> Join(const PointFieldView* const* views, int fields, vtkIdType count)
{
  const vtkDGG::PointField& first = views[0]->Field;
  auto array = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(DGGGetArrayType(first.Kind, first.Size)));
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

/// Floats or doubles as they are, doubles of anything else.
vtkSmartPointer<vtkDataArray> MakeCoordinates(const Vector& views, vtkIdType count)
{
  const auto getType = [&views](std::size_t c) {
    return DGGGetArrayType(views[c]->Field.Kind, views[c]->Field.Size);
  };
  if (views[0]->Field.Kind == 'F' && getType(0) == getType(1) && getType(0) == getType(2))
  {
    return Join(views.data(), 3, count);
  }
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(count);
  for (std::size_t c = 0; c < 3; ++c)
  {
    DGGDispatchNumber(getType(c), [&](auto number) {
      const char* in = views[c]->Data;
      for (vtkIdType i = 0; i < count; ++i, in += views[c]->Stride)
      {
        std::memcpy(&number, in, sizeof(number));
        array->SetTypedComponent(i, static_cast<int>(c), static_cast<double>(number));
      }
    });
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
  for (vtkIdType i = 0; i < count; ++i, in += view.Stride)
  {
    std::uint32_t packed = 0;
    std::memcpy(&packed, in, 4);
    for (const int shift : { 16, 8, 0, 24 })
    {
      if (shift < 24 || components == 4)
      {
        *out++ = static_cast<unsigned char>(packed >> shift);
      }
    }
  }
  return array;
}

/// One vertex for each point that has a place.
vtkSmartPointer<vtkCellArray> MakeVertices(vtkDataArray* coordinates)
{
  const vtkIdType count = coordinates->GetNumberOfTuples();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  if (count < std::numeric_limits<std::int32_t>::max())
  {
    cells->Use32BitStorage();
  }
  cells->AllocateExact(count, count);
  double p[3];
  for (vtkIdType i = 0; i < count; ++i)
  {
    coordinates->GetTuple(i, p);
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
    {
      cells->InsertNextCell(1, &i);
    }
  }
  cells->Squeeze();
  return cells;
}
}

bool vtkDGG::IsPointFieldType(char kind, int size)
{
  return DGGGetArrayType(kind, size) != VTK_VOID;
}

std::string vtkDGG::CheckPointFields(const PointCloudView& cloud)
{
  FieldTable table;
  for (const PointFieldView& view : cloud.Fields)
  {
    const PointField& field = view.Field;
    if (!IsPointFieldType(field.Kind, field.Size) || field.Count < 1)
    {
      return "the field '" + field.Name + "' has numbers of no known type, or none";
    }
    if (field.Name != DGGPaddingName && !table.Views.emplace(field.Name, &view).second)
    {
      return "two fields '" + field.Name + "'";
    }
  }
  for (const std::string name : { "x", "y", "z" })
  {
    const PointFieldView* view = table.Find(name);
    if (!view)
    {
      return "no field '" + name + "': a point cloud needs the fields x, y and z";
    }
    if (view->Field.Count != 1)
    {
      return "the field '" + name + "' has " + std::to_string(view->Field.Count) +
        " values per point, expected one";
    }
  }
  // Arrays of one name would replace each other.
  const struct
  {
    const PointFieldView* View;
    const char* Fields;
    const char* Array;
  } made[] = { { table.FindNormals()[0], "normal_x, normal_y, normal_z", "Normals" },
    { table.FindColor("rgb"), "rgb", "RGB" }, { table.FindColor("rgba"), "rgba", "RGBA" } };
  for (const auto& array : made)
  {
    if (array.View && table.Find(array.Array))
    {
      return std::string("the fields ") + array.Fields + " and '" + array.Array +
        "' would both become the array " + array.Array;
    }
  }
  return std::string();
}

vtkSmartPointer<vtkPolyData> vtkDGG::MakePolyData(const PointCloudView& cloud, std::string& error)
{
  error = CheckPointFields(cloud);
  if (error.empty() &&
    (cloud.Width < 0 || cloud.Height < 0 ||
      (cloud.Height > 0 && cloud.Width > VTK_ID_MAX / cloud.Height)))
  {
    error = "the width or the height is out of range";
  }
  if (!error.empty())
  {
    return nullptr;
  }
  FieldTable table;
  for (const PointFieldView& view : cloud.Fields)
  {
    table.Views.emplace(view.Field.Name, &view);
  }
  const vtkIdType count = cloud.Width * cloud.Height;
  auto output = vtkSmartPointer<vtkPolyData>::New();
  const Vector coordinates = table.FindVector("");
  vtkNew<vtkPoints> points;
  points->SetData(MakeCoordinates(coordinates, count));
  output->SetPoints(points);
  output->SetVerts(MakeVertices(points->GetData()));

  vtkPointData* data = output->GetPointData();
  const Vector normals = table.FindNormals();
  if (normals[0])
  {
    vtkSmartPointer<vtkDataArray> array = Join(normals.data(), 3, count);
    array->SetName("Normals");
    data->SetNormals(array);
  }
  const PointFieldView* rgba = table.FindColor("rgba");
  if (rgba)
  {
    data->SetScalars(MakeColors(*rgba, 4, count));
  }
  const PointFieldView* rgb = table.FindColor("rgb");
  if (rgb)
  {
    data->AddArray(MakeColors(*rgb, 3, count));
    data->SetActiveScalars("RGB");
  }
  for (const PointFieldView& view : cloud.Fields)
  {
    const auto isOneOf = [&view](const Vector& vector) {
      return std::find(vector.begin(), vector.end(), &view) != vector.end();
    };
    if (view.Field.Name != DGGPaddingName && !isOneOf(coordinates) && !isOneOf(normals) &&
      &view != rgba && &view != rgb)
    {
      const PointFieldView* views[] = { &view };
      vtkSmartPointer<vtkDataArray> array = Join(views, 1, count);
      array->SetName(view.Field.Name.c_str());
      data->AddArray(array);
    }
  }

  vtkNew<vtkTypeInt64Array> dimensions;
  dimensions->SetName(DGGDimensionsName);
  dimensions->InsertNextValue(cloud.Width);
  dimensions->InsertNextValue(cloud.Height);
  output->GetFieldData()->AddArray(dimensions);
  vtkNew<vtkDoubleArray> viewpoint;
  viewpoint->SetName(DGGViewpointName);
  std::for_each(cloud.Sensor.begin(), cloud.Sensor.end(),
    [&viewpoint](double value) { viewpoint->InsertNextValue(value); });
  output->GetFieldData()->AddArray(viewpoint);
  return output;
}
