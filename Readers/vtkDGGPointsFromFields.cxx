// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPointFields.h"

#include "vtkDGGPointFieldTable.h"
#include "vtkDGGPointNumbers.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace
{
using vtkDGG::PointField;
using vtkDGG::PointFieldView;

double GetNumber(const PointField& field, const char* data)
{
  double number = 0.0;
  vtkDGGDispatchNumber(field.Kind, field.Size, [data, &number](auto example) {
    std::memcpy(&example, data, sizeof(example));
    number = static_cast<double>(example);
  });
  return number;
}

void CopyValues(
  const PointFieldView& view, vtkIdType count, int component, int components, char* out)
{
  const std::size_t bytes = view.Field.GetBytes();
  const std::size_t step = static_cast<std::size_t>(components) * view.Field.Size;
  out += static_cast<std::size_t>(component) * view.Field.Size;
  const char* in = view.Data;
  for (vtkIdType i = 0; i < count; ++i, in += view.Stride, out += step)
  {
    std::memcpy(out, in, bytes);
  }
}

/// Several fields of one number each, of one type, as the components of an array.
vtkSmartPointer<vtkDataArray> Join(
  const PointFieldView* const* views, int components, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(vtkDGGGetArrayType(views[0]->Field.Kind, views[0]->Field.Size)));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  for (int c = 0; c < components && count > 0; ++c)
  {
    CopyValues(*views[c], count, c, components, static_cast<char*>(array->GetVoidPointer(0)));
  }
  return array;
}

vtkSmartPointer<vtkDataArray> MakeCoordinates(const PointFieldView* const* views, vtkIdType count)
{
  if (views[0]->Field.Kind == 'F' && vtkDGGHaveSameType(views))
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
  vtkDGGPointFieldTable table;
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
    const int components = view->Field.Count;
    auto array = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(vtkDGGGetArrayType(view->Field.Kind, view->Field.Size)));
    array->SetName(view->Field.Name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(count);
    if (count > 0)
    {
      CopyValues(*view, count, 0, components, static_cast<char*>(array->GetVoidPointer(0)));
    }
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
