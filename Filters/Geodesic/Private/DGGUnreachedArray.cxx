// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGUnreachedArray.h"

#include "DGGMakeArray.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
std::string NameOf(const std::string& distances)
{
  return distances + ".Unreached";
}
}

//------------------------------------------------------------------------------
void DGGUnreachedArray::AddTo(vtkPointData* data, const std::string& distances,
  double unreachedValue, const std::vector<bool>& isReached)
{
  const bool isPlain =
    std::isnan(unreachedValue) || unreachedValue == std::numeric_limits<double>::infinity();
  if (isPlain || std::find(isReached.begin(), isReached.end(), false) == isReached.end())
  {
    return;
  }
  const auto array = DGGAddArray<vtkUnsignedCharArray>(data, NameOf(distances), isReached.size());
  std::transform(isReached.begin(), isReached.end(), array->GetPointer(0),
    [](bool reached) { return static_cast<unsigned char>(reached ? 0 : 1); });
}

//------------------------------------------------------------------------------
void DGGUnreachedArray::RemoveFrom(vtkPointData* data, const std::string& distances)
{
  data->RemoveArray(NameOf(distances).c_str());
}

//------------------------------------------------------------------------------
std::vector<bool> DGGUnreachedArray::Find(
  vtkPointData* data, vtkDataArray* distances, double unreachedValue)
{
  const vtkIdType n = distances->GetNumberOfTuples();
  std::vector<bool> isUnreached(static_cast<std::size_t>(n));
  if (!std::isnan(unreachedValue))
  {
    // Value after conversion to the type of the array.
    const double wanted = distances->GetDataType() == VTK_FLOAT
      ? static_cast<double>(static_cast<float>(unreachedValue))
      : unreachedValue;
    for (vtkIdType i = 0; i < n; ++i)
    {
      isUnreached[i] = distances->GetComponent(i, 0) == wanted;
    }
    return isUnreached;
  }
  const char* name = distances->GetName();
  vtkDataArray* mask = name ? data->GetArray(NameOf(name).c_str()) : nullptr;
  if (!mask || mask->GetNumberOfComponents() != 1 || mask->GetNumberOfTuples() != n)
  {
    return {};
  }
  for (vtkIdType i = 0; i < n; ++i)
  {
    isUnreached[i] = mask->GetComponent(i, 0) != 0.0;
  }
  return isUnreached;
}
