// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGMeshConversion.h"

#include "DGGCompatibility.h"
#include "dggNumberTypes.h"
#include "vtkDGGPointFields.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleStrip.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace
{
/// Copies values, and releases the originals.
template <typename T>
vtkSmartPointer<vtkDataArray> MakeArray(
  std::vector<T>& values, int components, const char* name = nullptr)
{
  constexpr bool isLong = std::is_integral<T>::value && sizeof(T) == 8;
  constexpr int longType = std::is_signed<T>::value ? VTK_TYPE_INT64 : VTK_TYPE_UINT64;
  auto array = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(isLong ? longType : vtkTypeTraits<T>::VTK_TYPE_ID));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  if (!values.empty())
  {
    std::memcpy(array->GetVoidPointer(0), values.data(), values.size() * sizeof(T));
  }
  std::vector<T>().swap(values);
  return array;
}

void AddArrays(std::vector<dgg::DataArray>& arrays, vtkDataSetAttributes* data)
{
  for (dgg::DataArray& in : arrays)
  {
    vtkSmartPointer<vtkDataArray> array = std::visit(
      [&in](auto& values) { return MakeArray(values, in.Components, in.Name.c_str()); }, in.Values);
    data->AddArray(array);
    switch (in.Role)
    {
      case dgg::ArrayRole::Normals:
        data->SetActiveNormals(array->GetName());
        break;
      case dgg::ArrayRole::TCoords:
        data->SetActiveTCoords(array->GetName());
        break;
      case dgg::ArrayRole::Colors:
        data->SetActiveScalars(array->GetName());
        break;
      default:
        break;
    }
  }
}

vtkSmartPointer<vtkCellArray> MakeCells(dgg::CellList& list)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(MakeArray(list.Offsets, 1), MakeArray(list.Connectivity, 1));
  return cells;
}
/// Copies cells, whose ids must be below `count`. Cells without points are skipped.
bool AddCells(vtkCellArray* cells, vtkIdType count, dgg::CellList& list, std::vector<bool>& areKept)
{
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(i, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      if (ids[k] < 0 || ids[k] >= count)
      {
        return false;
      }
      list.Connectivity.push_back(ids[k]);
    }
    areKept.push_back(size > 0);
    if (size > 0)
    {
      list.EndCell();
    }
  }
  return true;
}

/// Removes the values of skipped cells.
void RemoveValues(const std::vector<bool>& areKept, dgg::DataArray& array)
{
  const int components = array.Components;
  std::visit(
    [&](auto& values) {
      std::decay_t<decltype(values)> kept;
      for (std::size_t i = 0; i < areKept.size(); ++i)
      {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(i) * components;
        kept.insert(kept.end(), first, first + (areKept[i] ? components : 0));
      }
      values = std::move(kept);
    },
    array.Values);
}

/// Copies the values; bits become bytes.
dgg::DataArray ReadArray(vtkDataArray* array)
{
  vtkSmartPointer<vtkDataArray> plain = array;
  if (array->GetDataType() == VTK_BIT || !array->HasStandardMemoryLayout())
  {
    plain.TakeReference(vtkDataArray::CreateDataArray(
      array->GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : array->GetDataType()));
    plain->DeepCopy(array);
  }
  dgg::NumberType type;
  switch (plain->GetDataType())
  {
    vtkTemplateMacro(type = dgg::TypeOf<VTK_TT>());
  }
  dgg::DataArray result;
  result.Name = array->GetName() ? array->GetName() : "";
  result.Components = array->GetNumberOfComponents();
  const auto count = static_cast<std::size_t>(plain->GetNumberOfValues());
  result.Values = dgg::MakeValues(type, count);
  std::visit(
    [&](auto& values) {
      if (count > 0)
      {
        std::memcpy(values.data(), plain->GetVoidPointer(0), count * sizeof(values[0]));
      }
    },
    result.Values);
  return result;
}

/// Returns the array of colors with `components` components, or null.
vtkDataArray* FindColors(vtkDataSetAttributes* data, int components)
{
  for (vtkDataArray* array :
    { data->GetArray(components == 3 ? "RGB" : "RGBA"), data->GetScalars() })
  {
    if (array && array->GetDataType() == VTK_UNSIGNED_CHAR &&
      array->GetNumberOfComponents() == components)
    {
      return array;
    }
  }
  return nullptr;
}

/// Copies all arrays of numbers, the active ones first. An array that does not fit the points or
/// cells is an error, which names their kind, or skipped if `kind` is null.
dgg::FileStatus ReadArrays(vtkDataSetAttributes* data, const char* kind, vtkIdType count,
  std::vector<dgg::DataArray>& result)
{
  const auto isVector = [](vtkDataArray* array, int components) {
    return array && array->GetNumberOfComponents() == components &&
      (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
  };
  std::vector<std::pair<vtkDataArray*, dgg::ArrayRole>> arrays;
  if (isVector(data->GetNormals(), 3))
  {
    arrays.emplace_back(data->GetNormals(), dgg::ArrayRole::Normals);
  }
  if (isVector(data->GetTCoords(), 2))
  {
    arrays.emplace_back(data->GetTCoords(), dgg::ArrayRole::TCoords);
  }
  vtkDataArray* colors[] = { FindColors(data, 3), FindColors(data, 4) };
  if (colors[1] == data->GetScalars())
  {
    std::swap(colors[0], colors[1]);
  }
  for (vtkDataArray* array : colors)
  {
    if (array)
    {
      arrays.emplace_back(array, dgg::ArrayRole::Colors);
    }
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i); // null for strings
    if (array && array->GetNumberOfComponents() > 0 &&
      std::none_of(
        arrays.begin(), arrays.end(), [array](const auto& other) { return other.first == array; }))
    {
      arrays.emplace_back(array, dgg::ArrayRole::None);
    }
  }
  for (const auto& [array, role] : arrays)
  {
    if (array->GetNumberOfTuples() != count)
    {
      if (!kind)
      {
        continue;
      }
      return { dgg::FileStatus::Code::Malformed,
        std::string("the ") + kind + " array " + (array->GetName() ? array->GetName() : "") +
          " has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
          std::to_string(count) + " " + kind + "s." };
    }
    result.push_back(ReadArray(array));
    result.back().Role = role;
  }
  return {};
}
/// Copies the coordinates and the layout of a cloud.
void ReadPoints(vtkPolyData* input, dgg::MeshData& mesh)
{
  mesh.HasFloatPoints = true;
  if (input->GetPoints())
  {
    vtkDataArray* points = input->GetPoints()->GetData();
    mesh.HasFloatPoints = points->GetDataType() == VTK_FLOAT;
    std::visit([&mesh](const auto& values) { mesh.Points.assign(values.begin(), values.end()); },
      ReadArray(points).Values);
  }
  dgg::PointCloudView layout;
  vtkDGG::GetPointCloudLayout(input, layout);
  mesh.Layout = layout;
}
}

unsigned long vtkDGG::RunOnFile(vtkAlgorithm* algorithm, const char* verb, const char* fileName,
  const std::function<dgg::FileStatus(const dgg::FileProgress&)>& work)
{
  if (!fileName || !fileName[0])
  {
    vtkErrorWithObjectMacro(algorithm, "There is no file name. Set FileName.");
    return vtkErrorCode::NoFileNameError;
  }
  algorithm->SetAbortExecute(0); // some versions of VTK keep the flag of an earlier run
  dgg::FileStatus status;
  try
  {
    status = work([algorithm](double done) {
      algorithm->UpdateProgress(done);
      return !vtkDGGIsAbortedMacro(algorithm);
    });
  }
  catch (const std::bad_alloc&) // from VTK's containers
  {
    status = { dgg::FileStatus::Code::OutOfMemory, "not enough memory." };
  }
  constexpr unsigned long codes[] = { vtkErrorCode::NoError, vtkErrorCode::FileNotFoundError,
    vtkErrorCode::CannotOpenFileError, vtkErrorCode::UnrecognizedFileTypeError,
    vtkErrorCode::PrematureEndOfFileError, vtkErrorCode::FileFormatError,
    vtkErrorCode::OutOfDiskSpaceError, vtkErrorCode::UnknownError, vtkErrorCode::NoError };
  const unsigned long code = codes[static_cast<int>(status.Kind)];
  if (code != vtkErrorCode::NoError)
  {
    vtkErrorWithObjectMacro(
      algorithm, "Cannot " << verb << " " << fileName << ": " << status.Message);
  }
  return code;
}

dgg::FileStatus vtkDGG::FromPolyData(vtkPolyData* input, dgg::MeshData& mesh)
{
  const vtkIdType count = input->GetNumberOfPoints();
  ReadPoints(input, mesh);
  vtkNew<vtkCellArray> triangles;
  vtkCellArray* strips = input->GetStrips();
  for (vtkIdType i = 0; i < strips->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    strips->GetCellAtId(i, size, ids);
    vtkTriangleStrip::DecomposeStrip(static_cast<int>(size), ids, triangles);
  }
  std::vector<bool> areKept;
  if (!AddCells(input->GetVerts(), count, mesh.Verts, areKept) ||
    !AddCells(input->GetLines(), count, mesh.Lines, areKept) ||
    !AddCells(input->GetPolys(), count, mesh.Polygons, areKept) ||
    !AddCells(triangles, count, mesh.Polygons, areKept))
  {
    return { dgg::FileStatus::Code::Malformed,
      "a cell has a point id that is out of range: the number of points is " +
        std::to_string(count) + "." };
  }
  dgg::FileStatus status = ReadArrays(input->GetPointData(), "point", count, mesh.PointArrays);
  if (status.IsOk() && strips->GetNumberOfCells() == 0)
  {
    status = ReadArrays(input->GetCellData(), "cell", input->GetNumberOfCells(), mesh.CellArrays);
  }
  if (std::find(areKept.begin(), areKept.end(), false) != areKept.end())
  {
    for (dgg::DataArray& array : mesh.CellArrays)
    {
      RemoveValues(areKept, array);
    }
  }
  return status;
}

dgg::MeshData vtkDGG::FromPointsOf(vtkPolyData* input)
{
  dgg::MeshData mesh;
  ReadPoints(input, mesh);
  ReadArrays(input->GetPointData(), nullptr, input->GetNumberOfPoints(), mesh.PointArrays);
  return mesh;
}

void vtkDGG::ToPolyData(dgg::MeshData&& mesh, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  if (mesh.HasFloatPoints)
  {
    std::vector<float> coordinates(mesh.Points.begin(), mesh.Points.end());
    points->SetData(MakeArray(coordinates, 3));
  }
  else
  {
    points->SetData(MakeArray(mesh.Points, 3));
  }
  output->SetPoints(points);
  if (mesh.Verts.GetCount() > 0)
  {
    output->SetVerts(MakeCells(mesh.Verts));
  }
  if (mesh.Lines.GetCount() > 0)
  {
    output->SetLines(MakeCells(mesh.Lines));
  }
  output->SetPolys(MakeCells(mesh.Polygons));
  AddArrays(mesh.PointArrays, output->GetPointData());
  AddArrays(mesh.CellArrays, output->GetCellData());
  if (mesh.Layout)
  {
    vtkFieldData* data = output->GetFieldData();
    std::vector<std::int64_t> size = { mesh.Layout->Width, mesh.Layout->Height };
    data->AddArray(MakeArray(size, 1, DimensionsName));
    std::vector<double> sensor(mesh.Layout->Sensor.begin(), mesh.Layout->Sensor.end());
    data->AddArray(MakeArray(sensor, 1, ViewpointName));
  }
}
