// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGMeshConversion.h"

#include "DGGCompatibility.h"
#include "dggMeshArrays.h"
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

vtkSmartPointer<vtkDataArray> MakeArray(dgg::DataArray& in)
{
  return std::visit(
    [&in](auto& values) { return MakeArray(values, in.Components, in.Name.c_str()); }, in.Values);
}

void AddArrays(std::vector<dgg::DataArray>& arrays, vtkDataSetAttributes* data)
{
  for (dgg::DataArray& in : arrays)
  {
    const vtkSmartPointer<vtkDataArray> array = MakeArray(in);
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

void AddCells(vtkCellArray* cells, dgg::CellList& list)
{
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(i, size, ids);
    list.Connectivity.insert(list.Connectivity.end(), ids, ids + size);
    list.EndCell();
  }
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

/// Copies all arrays of numbers, those with a role first.
std::vector<dgg::DataArray> ReadArrays(vtkDataSetAttributes* data)
{
  std::vector<dgg::DataArray> result;
  dgg::ActiveArrays active;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i); // null for strings
    if (!array || array->GetNumberOfComponents() == 0)
    {
      continue;
    }
    const auto index = static_cast<int>(result.size());
    active.Normals = array == data->GetNormals() ? index : active.Normals;
    active.TCoords = array == data->GetTCoords() ? index : active.TCoords;
    active.Scalars = array == data->GetScalars() ? index : active.Scalars;
    result.push_back(ReadArray(array));
  }
  dgg::SetRoles(result, active);
  return result;
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

dgg::MeshData vtkDGG::FromPolyData(vtkPolyData* input)
{
  dgg::MeshData mesh;
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
  AddCells(input->GetVerts(), mesh.Verts);
  AddCells(input->GetLines(), mesh.Lines);
  AddCells(input->GetPolys(), mesh.Polygons);
  AddCells(triangles, mesh.Polygons);
  mesh.PointArrays = ReadArrays(input->GetPointData());
  if (strips->GetNumberOfCells() == 0)
  {
    mesh.CellArrays = ReadArrays(input->GetCellData());
  }
  return mesh;
}

dgg::MeshData vtkDGG::FromPointsOf(vtkPolyData* input)
{
  dgg::MeshData mesh;
  ReadPoints(input, mesh);
  const auto count = static_cast<std::size_t>(input->GetNumberOfPoints());
  for (dgg::DataArray& array : ReadArrays(input->GetPointData()))
  {
    const std::size_t values = std::visit([](const auto& v) { return v.size(); }, array.Values);
    if (values == count * static_cast<std::size_t>(array.Components))
    {
      mesh.PointArrays.push_back(std::move(array));
    }
  }
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
    for (dgg::DataArray& array : dgg::MakeLayoutArrays(*mesh.Layout))
    {
      output->GetFieldData()->AddArray(MakeArray(array));
    }
  }
}
