// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGSpectralOutputs.h"

#include "DGGMakeArray.h"

#include "dggBuffer.h"
#include "dggPreparedSurface.h"

#include "vtkIdTypeArray.h"

#include <algorithm>

namespace
{
vtkSmartPointer<vtkDoubleArray> MakeArray(
  const std::string& name, std::size_t tuples, std::size_t components)
{
  dgg::Buffer<double> values(tuples * components); // throws where VTK may abort
  std::fill(values.begin(), values.end(), 0.0);
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(std::max(1, static_cast<int>(components)));
  const auto size = static_cast<vtkIdType>(values.Size());
  if (size > 0)
  {
    array->SetArray(values.Release(), size, 0, vtkDoubleArray::VTK_DATA_ARRAY_FREE);
  }
  return array;
}
}

//------------------------------------------------------------------------------
double DGGSpectralOutputs::EstimateMemory(
  std::size_t numberOfPoints, std::size_t numberOfTargets, std::size_t numberOfSources)
{
  return static_cast<double>(numberOfPoints + numberOfTargets) *
    static_cast<double>(numberOfSources) * sizeof(double);
}

//------------------------------------------------------------------------------
DGGSpectralOutputs::DGGSpectralOutputs(const dgg::PreparedSurface& mesh, std::size_t numberOfPoints,
  std::size_t numberOfTargets, std::size_t numberOfSources, const std::string& name)
  : Mesh(mesh)
  , NumberOfPoints(numberOfPoints)
{
  if (numberOfSources > 0)
  {
    this->AtPoints = MakeArray(name, numberOfPoints, numberOfSources);
    this->AtTargets = MakeArray(name, numberOfTargets, numberOfSources);
  }
}

//------------------------------------------------------------------------------
DGGSpectralOutputs::~DGGSpectralOutputs() = default;

//------------------------------------------------------------------------------
void DGGSpectralOutputs::Set(
  std::size_t source, const std::vector<double>& values, const std::vector<double>& targetValues)
{
  this->SetComponents(this->AtPoints, this->AtTargets, source, values, targetValues);
}

//------------------------------------------------------------------------------
void DGGSpectralOutputs::SetComponents(vtkDoubleArray* atPoints, vtkDoubleArray* atTargets,
  std::size_t component, const std::vector<double>& values,
  const std::vector<double>& targetValues) const
{
  const int k = static_cast<int>(component);
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(this->NumberOfPoints); ++i)
  {
    atPoints->SetTypedComponent(i, k, values[this->Mesh.GetVertex(i)]);
  }
  for (std::size_t i = 0; i < targetValues.size(); ++i)
  {
    atTargets->SetTypedComponent(static_cast<vtkIdType>(i), k, targetValues[i]);
  }
}

//------------------------------------------------------------------------------
void DGGSpectralOutputs::AddColumns(const std::string& name,
  const std::vector<std::vector<double>>& columns,
  const std::vector<std::vector<double>>& targetColumns)
{
  const auto atPoints = MakeArray(name, this->NumberOfPoints, columns.size());
  const auto atTargets = MakeArray(name, targetColumns[0].size(), columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k)
  {
    this->SetComponents(atPoints, atTargets, k, columns[k], targetColumns[k]);
  }
  this->Further[0].push_back(atPoints);
  this->Further[1].push_back(atTargets);
}

//------------------------------------------------------------------------------
template <typename ArrayType, typename Number>
void DGGSpectralOutputs::Add(const std::string& name, const std::vector<Number>& values,
  const std::vector<Number>& targetValues)
{
  const auto atPoints = DGGMakeArray<ArrayType>(name, this->NumberOfPoints);
  for (std::size_t i = 0; i < this->NumberOfPoints; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    atPoints->SetValue(id, values[this->Mesh.GetVertex(id)]);
  }
  const auto atTargets = DGGMakeArray<ArrayType>(name, targetValues.size());
  std::copy(targetValues.begin(), targetValues.end(), atTargets->GetPointer(0));
  this->Further[0].push_back(atPoints);
  this->Further[1].push_back(atTargets);
}

template void DGGSpectralOutputs::Add<vtkDoubleArray>(
  const std::string&, const std::vector<double>&, const std::vector<double>&);
template void DGGSpectralOutputs::Add<vtkIdTypeArray>(
  const std::string&, const std::vector<dgg::Id>&, const std::vector<dgg::Id>&);
