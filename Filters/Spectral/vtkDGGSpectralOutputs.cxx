// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGSpectralOutputs.h"

#include "vtkDGGMakeArray.h"
#include "vtkDGGMeshAdapter.h"

#include "dggBuffer.h"

#include "vtkIdTypeArray.h"

#include <algorithm>

namespace
{
/// The component of one source.
class Column
{
public:
  Column(vtkDoubleArray* array, std::size_t component)
    : Values(array->GetPointer(0))
    , Stride(static_cast<std::size_t>(array->GetNumberOfComponents()))
    , Component(component)
  {
  }
  double& operator[](std::size_t i) const { return this->Values[i * this->Stride + Component]; }

private:
  double* Values;
  std::size_t Stride;
  std::size_t Component;
};

template <typename ArrayType, typename Function>
vtkSmartPointer<ArrayType> ArrayOf(const std::string& name, vtkIdType count, Function&& valueOf)
{
  auto array = vtkDGGMakeArray<ArrayType>(name, static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetValue(i, valueOf(i));
  }
  return array;
}

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
double vtkDGGSpectralOutputs::EstimateMemory(
  std::size_t numberOfPoints, std::size_t numberOfTargets, std::size_t numberOfSources)
{
  return static_cast<double>(numberOfPoints + numberOfTargets) *
    static_cast<double>(numberOfSources) * sizeof(double);
}

//------------------------------------------------------------------------------
vtkDGGSpectralOutputs::vtkDGGSpectralOutputs(const vtkDGGMeshAdapter& mesh,
  std::size_t numberOfPoints, std::size_t numberOfTargets, std::size_t numberOfSources,
  const std::string& name)
  : Mesh(mesh)
  , AtPoints(MakeArray(name, numberOfPoints, numberOfSources))
  , AtTargets(MakeArray(name, numberOfTargets, numberOfSources))
{
}

//------------------------------------------------------------------------------
vtkDGGSpectralOutputs::~vtkDGGSpectralOutputs() = default;

//------------------------------------------------------------------------------
void vtkDGGSpectralOutputs::Set(
  std::size_t source, const std::vector<double>& values, const std::vector<double>& targetValues)
{
  const Column atPoints(this->AtPoints, source);
  const vtkIdType n = this->AtPoints->GetNumberOfTuples();
  for (vtkIdType i = 0; i < n; ++i)
  {
    atPoints[static_cast<std::size_t>(i)] = values[this->Mesh.GetVertex(i)];
  }
  const Column atTargets(this->AtTargets, source);
  for (std::size_t i = 0; i < targetValues.size(); ++i)
  {
    atTargets[i] = targetValues[i];
  }
}

//------------------------------------------------------------------------------
void vtkDGGSpectralOutputs::Add(const std::string& name, const std::vector<double>& values,
  const std::vector<double>& targetValues)
{
  this->Further[0].push_back(ArrayOf<vtkDoubleArray>(name, this->AtPoints->GetNumberOfTuples(),
    [&](vtkIdType i) { return values[this->Mesh.GetVertex(i)]; }));
  this->Further[1].push_back(ArrayOf<vtkDoubleArray>(
    name, this->AtTargets->GetNumberOfTuples(), [&](vtkIdType i) { return targetValues[i]; }));
}

//------------------------------------------------------------------------------
void vtkDGGSpectralOutputs::AddNumbers(const std::string& name, const std::vector<dgg::Id>& values,
  const std::vector<dgg::Id>& targetValues)
{
  this->Further[0].push_back(ArrayOf<vtkIdTypeArray>(name, this->AtPoints->GetNumberOfTuples(),
    [&](vtkIdType i) { return values[this->Mesh.GetVertex(i)]; }));
  this->Further[1].push_back(ArrayOf<vtkIdTypeArray>(
    name, this->AtTargets->GetNumberOfTuples(), [&](vtkIdType i) { return targetValues[i]; }));
}
