// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGUnreachedArray.h"

#include "vtkDGGMakeArray.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
const char* const Suffix = ".Unreached";
/// Where things are in the array; ids come last.
constexpr vtkIdType Value = 0;
constexpr vtkIdType NumberOfPoints = 1;
constexpr vtkIdType FirstId = 2;

/// The number as an array of that type has it.
double Round(vtkDataArray* distances, double number)
{
  return distances->GetDataType() == VTK_FLOAT ? static_cast<double>(static_cast<float>(number))
                                               : number;
}

bool HasLayout(vtkDataArray* array)
{
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() < FirstId)
  {
    return false;
  }
  const double count = array->GetComponent(NumberOfPoints, 0);
  return count >= 0.0 && count == std::floor(count);
}

vtkDataArray* FindArray(vtkFieldData* data, vtkDataArray* distances)
{
  const char* name = distances->GetName();
  vtkDataArray* array =
    data && name ? data->GetArray((name + std::string(Suffix)).c_str()) : nullptr;
  return HasLayout(array) ? array : nullptr;
}
}

//------------------------------------------------------------------------------
void vtkDGGUnreachedArray::AddTo(vtkFieldData* data, vtkDataArray* distances, double unreachedValue,
  const std::vector<bool>& isReached)
{
  const bool isPlain =
    std::isnan(unreachedValue) || unreachedValue == std::numeric_limits<double>::infinity();
  if (isPlain || std::find(isReached.begin(), isReached.end(), false) == isReached.end())
  {
    return;
  }
  std::vector<double> values{ unreachedValue, static_cast<double>(isReached.size()) };
  for (std::size_t i = 0; i < isReached.size(); ++i)
  {
    if (isReached[i] && distances->GetComponent(static_cast<vtkIdType>(i), 0) == unreachedValue)
    {
      values.push_back(static_cast<double>(i));
    }
  }
  const auto array =
    vtkDGGAddArray<vtkDoubleArray>(data, distances->GetName() + std::string(Suffix), values.size());
  std::copy(values.begin(), values.end(), array->GetPointer(0));
}

//------------------------------------------------------------------------------
void vtkDGGUnreachedArray::RemoveFrom(vtkFieldData* data, const std::string& distances)
{
  data->RemoveArray((distances + Suffix).c_str());
}

//------------------------------------------------------------------------------
void vtkDGGUnreachedArray::RemoveAllFrom(vtkFieldData* data, vtkFieldData* points)
{
  const std::string suffix = Suffix;
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const std::string name = data->GetArrayName(i) ? data->GetArrayName(i) : "";
    if (name.size() <= suffix.size() ||
      name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0 ||
      !HasLayout(data->GetArray(i)))
    {
      continue;
    }
    vtkDataArray* distances = points->GetArray(name.substr(0, name.size() - suffix.size()).c_str());
    if (distances && distances->GetNumberOfComponents() == 1)
    {
      data->RemoveArray(i);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<bool> vtkDGGUnreachedArray::Find(
  vtkFieldData* data, vtkDataArray* distances, double unreachedValue)
{
  vtkDataArray* told = FindArray(data, distances);
  if (std::isnan(unreachedValue))
  {
    if (!told)
    {
      return {};
    }
    unreachedValue = told->GetComponent(Value, 0);
  }
  const vtkIdType n = distances->GetNumberOfTuples();
  const double wanted = Round(distances, unreachedValue);
  std::vector<bool> isUnreached(static_cast<std::size_t>(n));
  for (vtkIdType i = 0; i < n; ++i)
  {
    isUnreached[i] = distances->GetComponent(i, 0) == wanted;
  }
  // Ids are those of other points where some have been removed since.
  const bool hasIds = told && told->GetComponent(Value, 0) == unreachedValue &&
    told->GetComponent(NumberOfPoints, 0) == static_cast<double>(n);
  for (vtkIdType k = FirstId; hasIds && k < told->GetNumberOfTuples(); ++k)
  {
    const double id = told->GetComponent(k, 0);
    if (id >= 0.0 && id < static_cast<double>(n))
    {
      isUnreached[static_cast<std::size_t>(id)] = false;
    }
  }
  return isUnreached;
}
