// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGMeshConversion.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <new>

namespace
{
/// Copies values, and releases the originals.
template <typename T>
vtkSmartPointer<vtkDataArray> MakeArray(std::vector<T>& values, int components)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(vtkTypeTraits<T>::VTK_TYPE_ID));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), static_cast<T*>(array->GetVoidPointer(0)));
  std::vector<T>().swap(values);
  return array;
}

void AddArrays(std::vector<dgg::DataArray>& arrays, vtkDataSetAttributes* data)
{
  for (dgg::DataArray& in : arrays)
  {
    vtkSmartPointer<vtkDataArray> array =
      std::visit([&in](auto& values) { return MakeArray(values, in.Components); }, in.Values);
    array->SetName(in.Name.c_str());
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
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->ShallowCopy(MakeArray(list.Offsets, 1));
  vtkNew<vtkTypeInt64Array> corners;
  corners->ShallowCopy(MakeArray(list.Connectivity, 1));
  cells->SetData(offsets, corners);
  return cells;
}
}

unsigned long vtkDGG::RunOnFile(vtkAlgorithm* algorithm, const char* verb, const char* fileName,
  const std::function<dgg::FileStatus(const dgg::FileProgress&)>& work)
{
  if (!fileName || !fileName[0])
  {
    vtkErrorWithObjectMacro(algorithm, "There is no file name: call SetFileName() first.");
    return vtkErrorCode::NoFileNameError;
  }
  algorithm->SetAbortExecute(0); // VTK 9.1 keeps the flag of an earlier run
  dgg::FileStatus status;
  try
  {
    status = work([algorithm](double done) {
      algorithm->UpdateProgress(done);
      return algorithm->GetAbortExecute() == 0;
    });
  }
  catch (const std::bad_alloc&) // from VTK's containers
  {
    status = { dgg::FileStatus::Code::OutOfMemory, "not enough memory" };
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
}
