// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGSurfaceArrays.h"

#include "DGGArrayView.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace
{
/// Returns the properties of an array, which may be null, without its values.
dgg::InputArray Describe(vtkAbstractArray* array, const std::string& name)
{
  dgg::InputArray described;
  described.Name = name;
  if (array)
  {
    described.Type = array->GetDataTypeAsString();
    described.NumberOfComponents = array->GetNumberOfComponents();
    described.NumberOfTuples = array->GetNumberOfTuples();
    described.AreNumbers = vtkDataArray::SafeDownCast(array) != nullptr;
    described.AreFloats = array->GetDataType() == VTK_FLOAT;
    described.AreBytes = array->GetDataType() == VTK_UNSIGNED_CHAR;
  }
  return described;
}
}

//------------------------------------------------------------------------------
DGGSurfaceArrays::DGGSurfaceArrays(vtkPolyData* input, bool withPoints, bool withCells)
{
  if (withPoints && input->GetNumberOfPoints() > 0)
  {
    vtkDataArray* points = input->GetPoints()->GetData();
    this->Arrays.NumberOfPoints = points->GetNumberOfTuples();
    this->Arrays.Points = this->ConvertPoints(points);
    this->Arrays.AreFromFloats = points->GetDataType() == VTK_FLOAT;
  }
  if (withCells)
  {
    this->Arrays.Polygons = this->ConvertCells(input->GetPolys());
    this->Arrays.Strips = this->ConvertCells(input->GetStrips());
    this->Arrays.FirstCell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  }
}

//------------------------------------------------------------------------------
const double* DGGSurfaceArrays::ConvertPoints(vtkDataArray* points)
{
  if (auto* doubles = vtkDoubleArray::FastDownCast(points))
  {
    return doubles->GetPointer(0);
  }
  this->Points.resize(static_cast<std::size_t>(points->GetNumberOfValues()));
  if (auto* floats = vtkFloatArray::FastDownCast(points))
  {
    std::copy_n(floats->GetPointer(0), this->Points.size(), this->Points.begin());
    return this->Points.data();
  }
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    points->GetTuple(i, this->Points.data() + 3 * i);
  }
  return this->Points.data();
}

//------------------------------------------------------------------------------
dgg::CellArrays DGGSurfaceArrays::ConvertCells(vtkCellArray* cells)
{
  if (!cells || cells->GetNumberOfCells() <= 0)
  {
    return {};
  }
  vtkDataArray* ids = cells->GetConnectivityArray();
  return { cells->GetNumberOfCells(), this->ConvertIds(cells->GetOffsetsArray()),
    this->ConvertIds(ids), ids->GetNumberOfValues() };
}

//------------------------------------------------------------------------------
const dgg::Offset* DGGSurfaceArrays::ConvertIds(vtkDataArray* ids)
{
  static_assert(sizeof(vtkTypeInt64) == sizeof(dgg::Offset));
  if (!ids)
  {
    return nullptr;
  }
  const dgg::StoredArray view = DGGViewArray(ids);
  if (view.Type == dgg::StoredArray::Int64)
  {
    return view.GetValues<dgg::Offset>();
  }
  auto& copy = this->Ids.emplace_back(static_cast<std::size_t>(view.Size));
  if (view.Type == dgg::StoredArray::Int32)
  {
    std::copy_n(view.GetValues<vtkTypeInt32>(), copy.size(), copy.begin());
    return copy.data();
  }
  for (std::size_t i = 0; i < copy.size(); ++i)
  {
    // A conversion to double could round the id.
    copy[i] = ids->GetVariantValue(static_cast<vtkIdType>(i)).ToTypeInt64();
  }
  return copy.data();
}

//------------------------------------------------------------------------------
std::function<const dgg::SurfaceArrays&()> DGGConvertCells(vtkPolyData* input)
{
  const auto arrays = std::make_shared<std::optional<DGGSurfaceArrays>>();
  return [input, arrays]() -> const dgg::SurfaceArrays& {
    if (!arrays->has_value())
    {
      arrays->emplace(input, false, true);
    }
    return (*arrays)->Get();
  };
}

//------------------------------------------------------------------------------
dgg::Status DGGCheckPointArray(vtkAbstractArray* array, vtkPolyData* data, const std::string& where,
  int components, vtkDataArray*& numbers)
{
  numbers = vtkDataArray::SafeDownCast(array);
  return Describe(array, array->GetName() ? array->GetName() : "(no name)")
    .CheckPoints(where, data->GetNumberOfPoints(), components);
}

//------------------------------------------------------------------------------
dgg::InputArray DGGReadArray(vtkAbstractArray* array, const std::string& name)
{
  dgg::InputArray read = Describe(array, name);
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    read.Values.resize(static_cast<std::size_t>(read.NumberOfTuples * read.NumberOfComponents));
    for (vtkIdType i = 0; i < read.NumberOfTuples; ++i)
    {
      numbers->GetTuple(i, read.Values.data() + i * read.NumberOfComponents);
    }
  }
  return read;
}

//------------------------------------------------------------------------------
dgg::InputArray DGGReadArray(vtkFieldData* data, const std::string& name)
{
  return DGGReadArray(data && !name.empty() ? data->GetAbstractArray(name.c_str()) : nullptr, name);
}
