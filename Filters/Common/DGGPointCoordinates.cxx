// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPointCoordinates.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <algorithm>

//------------------------------------------------------------------------------
DGGPointCoordinates::DGGPointCoordinates(vtkPoints* points)
{
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (auto* doubles = vtkDoubleArray::FastDownCast(points->GetData()))
  {
    this->Data = doubles->GetPointer(0);
    return;
  }
  this->Copy.resize(3 * static_cast<std::size_t>(points->GetNumberOfPoints()));
  if (auto* floats = vtkFloatArray::FastDownCast(points->GetData()))
  {
    std::copy_n(floats->GetPointer(0), this->Copy.size(), this->Copy.begin());
    this->Data = this->Copy.data();
    return;
  }
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, this->Copy.data() + 3 * i);
  }
  this->Data = this->Copy.data();
}
