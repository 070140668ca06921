// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGOutput.h"

#include "DGGGraphArrays.h"
#include "DGGMakeArray.h"
#include "DGGWindowArrays.h"

#include "dggStatus.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace
{
static_assert(sizeof(vtkIdType) == sizeof(dgg::Offset), "vtkDGG requires a VTK with 64-bit ids");

///@{
/// Returns the VTK array of a type of values.
vtkSmartPointer<vtkDataArray> Adopt(dgg::Buffer<double>& values, const char* name, int components)
{
  return DGGAdoptArray<vtkDoubleArray>(values, name, components);
}
vtkSmartPointer<vtkDataArray> Adopt(
  dgg::Buffer<std::int32_t>& values, const char* name, int components)
{
  return DGGAdoptArray<vtkIntArray>(values, name, components);
}
vtkSmartPointer<vtkDataArray> Adopt(
  dgg::Buffer<dgg::Offset>& values, const char* name, int components)
{
  return DGGAdoptArray<vtkIdTypeArray>(values, name, components);
}
vtkSmartPointer<vtkDataArray> Adopt(
  dgg::Buffer<std::uint8_t>& values, const char* name, int components)
{
  return DGGAdoptArray<vtkUnsignedCharArray>(values, name, components);
}
///@}

/// Returns an error if floats cannot represent the coordinates because the largest one overflows or
/// underflows.
dgg::Status CheckRange(const dgg::Buffer<double>& coordinates)
{
  double largest = 0.0;
  for (const double x : coordinates)
  {
    largest = std::max(largest, std::abs(x));
  }
  if (largest == 0.0 ||
    (largest >= std::numeric_limits<float>::min() && largest <= std::numeric_limits<float>::max()))
  {
    return dgg::Status::Success();
  }
  return dgg::InvalidInput("{OutputPointsPrecision} is single, but coordinates of up to ", largest,
    " are out of the range of floats")
    .At("OutputPointsPrecision")
    .Fix("Set {OutputPointsPrecision} to double");
}

/// Returns true if points of an output are floats. New points are not integers, even if the points
/// of the input are.
bool AreFloats(int precision, vtkPoints* input)
{
  return precision == vtkAlgorithm::SINGLE_PRECISION ||
    (precision == vtkAlgorithm::DEFAULT_PRECISION && input && input->GetDataType() == VTK_FLOAT);
}

vtkSmartPointer<vtkPoints> MakePoints(dgg::Buffer<double>& coordinates, bool areFloats)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  if (areFloats)
  {
    const auto floats = DGGMakeArray<vtkFloatArray>("Points", coordinates.Size() / 3, 3);
    std::transform(coordinates.begin(), coordinates.end(), floats->GetPointer(0),
      [](double x) { return static_cast<float>(x); });
    points->SetData(floats);
  }
  else
  {
    points->SetData(DGGAdoptArray<vtkDoubleArray>(coordinates, "Points", 3));
  }
  return points;
}

/// Copies the attributes of an input, except arrays whose number of tuples is wrong.
template <typename DataType>
vtkSmartPointer<DataType> CopyAttributes(DataType* data, vtkIdType tuples)
{
  auto copy = vtkSmartPointer<DataType>::New();
  copy->ShallowCopy(data);
  for (int i = copy->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (copy->GetAbstractArray(i)->GetNumberOfTuples() != tuples)
    {
      copy->RemoveArray(i);
    }
  }
  return copy;
}

/// Interpolates the point arrays of the input.
void PassPointArrays(dgg::Buffer<dgg::PointOrigin>& origins, vtkPolyData* input, vtkPointData* data)
{
  const auto from = CopyAttributes(input->GetPointData(), input->GetNumberOfPoints());
  data->InterpolateAllocate(from, static_cast<vtkIdType>(origins.Size()));
  vtkNew<vtkIdList> points;
  vtkIdType i = 0;
  for (dgg::PointOrigin& origin : origins)
  {
    if (origin.Points[1] == dgg::NoId)
    {
      data->CopyData(from, origin.Points[0], i++);
      continue;
    }
    points->Reset();
    for (const dgg::Id point : origin.Points)
    {
      points->InsertNextId(point);
    }
    data->InterpolatePoint(from, i++, points, origin.Weights.data());
  }
}

/// Copies the cell arrays of the input.
void PassCellArrays(const dgg::Buffer<dgg::Offset>& origins, vtkPolyData* input, vtkCellData* data)
{
  const auto from = CopyAttributes(input->GetCellData(), input->GetNumberOfCells());
  data->CopyAllocate(from, static_cast<vtkIdType>(origins.Size()));
  vtkIdType i = 0;
  for (const dgg::Offset cell : origins)
  {
    data->CopyData(from, cell, i++);
  }
}
}

//------------------------------------------------------------------------------
dgg::Status DGGFillOutput(dgg::Output& output, vtkPolyData* input, int precision, vtkPolyData* data)
{
  data->Initialize();
  data->GetFieldData()->PassData(input->GetFieldData());
  DGGGraphArrays::RemoveFrom(data->GetFieldData());
  DGGWindowArrays::RemoveAllFrom(data->GetFieldData());
  if (precision == vtkAlgorithm::SINGLE_PRECISION)
  {
    DGG_RETURN_IF_ERROR(CheckRange(output.Points));
  }
  data->SetPoints(MakePoints(output.Points, AreFloats(precision, input->GetPoints())));
  data->SetVerts(DGGMakeCells(output.Verts));
  data->SetLines(DGGMakeCells(output.Lines));
  data->SetPolys(DGGMakeCells(output.Polygons));
  if (output.PointOrigins)
  {
    PassPointArrays(*output.PointOrigins, input, data->GetPointData());
  }
  if (output.CellOrigins)
  {
    PassCellArrays(*output.CellOrigins, input, data->GetCellData());
  }
  DGGAddArrays(output, data);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> DGGMakeCells(dgg::OutputCells& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  if (cells.GetNumberOfCells() > 0)
  {
    array->SetData(DGGAdoptArray<vtkIdTypeArray>(cells.Offsets, nullptr),
      DGGAdoptArray<vtkIdTypeArray>(cells.Points, nullptr));
  }
  return array;
}

//------------------------------------------------------------------------------
void DGGAddArrays(dgg::Output& output, vtkPolyData* data)
{
  DGGAddArrays(output.PointData, data->GetPointData());
  DGGAddArrays(output.CellData, data->GetCellData());
  DGGAddArrays(output.FieldData, data->GetFieldData());
  // SetScalars() would remove the scalars of the input.
  if (!output.PointScalars.empty())
  {
    data->GetPointData()->SetActiveScalars(output.PointScalars.c_str());
  }
  if (!output.CellScalars.empty())
  {
    data->GetCellData()->SetActiveScalars(output.CellScalars.c_str());
  }
}

//------------------------------------------------------------------------------
void DGGAddArrays(dgg::OutputArrays& arrays, vtkFieldData* data)
{
  const bool areIds = vtkDataSetAttributes::SafeDownCast(data) != nullptr;
  for (dgg::OutputArray& array : arrays)
  {
    auto* integers = std::get_if<dgg::Buffer<dgg::Offset>>(&array.Values);
    if (integers && !areIds)
    {
      data->AddArray(
        DGGAdoptArray<vtkTypeInt64Array>(*integers, array.Name.c_str(), array.NumberOfComponents));
      continue;
    }
    data->AddArray(std::visit(
      [&array](
        auto& values) { return Adopt(values, array.Name.c_str(), array.NumberOfComponents); },
      array.Values));
  }
}
