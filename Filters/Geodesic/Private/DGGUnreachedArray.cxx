// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGUnreachedArray.h"

#include "DGGWindowArrays.h"

#include "dggDistanceOutput.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

//------------------------------------------------------------------------------
void DGGRemoveDistances(vtkPolyData* surface, const std::string& distances)
{
  surface->GetPointData()->RemoveArray(dgg::GetUnreachedName(distances).c_str());
  DGGWindowArrays::RemoveFrom(surface->GetFieldData(), distances);
}

//------------------------------------------------------------------------------
std::vector<bool> DGGFindUnreached(
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
  vtkDataArray* mask = name ? data->GetArray(dgg::GetUnreachedName(name).c_str()) : nullptr;
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
