// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGSpectralOutputs.h"

#include "DGGMakeArray.h"
#include "DGGPreparedMesh.h"

#include "dggBuffer.h"

#include "vtkIdTypeArray.h"

#include <algorithm>

namespace
{
vtkSmartPointer<vtkDoubleArray> MakeArray(
  const std::string& name, std::size_t tuples, std::size_t components)
{
  dgg::Buffer<double> values(tuples * components); // VTK may abort where this throws
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
DGGSpectralOutputs::DGGSpectralOutputs(const DGGPreparedMesh& mesh, std::size_t numberOfPoints,
  std::size_t numberOfTargets, std::size_t numberOfSources, const std::string& name)
  : Mesh(mesh)
  , AtPoints(MakeArray(name, numberOfPoints, numberOfSources))
  , AtTargets(MakeArray(name, numberOfTargets, numberOfSources))
{
}

//------------------------------------------------------------------------------
DGGSpectralOutputs::~DGGSpectralOutputs() = default;

//------------------------------------------------------------------------------
void DGGSpectralOutputs::Set(
  std::size_t source, const std::vector<double>& values, const std::vector<double>& targetValues)
{
  const int component = static_cast<int>(source);
  for (vtkIdType i = 0; i < this->AtPoints->GetNumberOfTuples(); ++i)
  {
    this->AtPoints->SetTypedComponent(i, component, values[this->Mesh.GetVertex(i)]);
  }
  for (std::size_t i = 0; i < targetValues.size(); ++i)
  {
    this->AtTargets->SetTypedComponent(static_cast<vtkIdType>(i), component, targetValues[i]);
  }
}

//------------------------------------------------------------------------------
template <typename ArrayType, typename Number>
void DGGSpectralOutputs::Add(const std::string& name, const std::vector<Number>& values,
  const std::vector<Number>& targetValues)
{
  const auto points = static_cast<std::size_t>(this->AtPoints->GetNumberOfTuples());
  const auto atPoints = DGGMakeArray<ArrayType>(name, points);
  for (std::size_t i = 0; i < points; ++i)
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
