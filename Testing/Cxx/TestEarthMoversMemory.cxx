// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Memory use of vtkSurfaceEarthMoversDistance against its prediction.
#include "../Benchmark/MemoryProbe.h"
#include "FilterTestTools.h"

#include "vtkSurfaceEarthMoversDistance.h"

#include "vtkErrorCode.h"

#include <cstddef>

using namespace dggtest;

namespace
{
/// Adds mass at all points, most of it at one point.
void AddMasses(vtkPolyData* surface, const char* name, vtkIdType most)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(i == most ? 1000.0 : 1.0);
  }
  surface->GetPointData()->AddArray(array);
}

/// Returns the smallest limit without an error, to 1 %.
double FindLeastLimit(vtkSurfaceEarthMoversDistance* filter)
{
  double refused = 1000.0;
  double accepted = 1e9;
  while (accepted > 1.01 * refused)
  {
    const double limit = 0.5 * (refused + accepted);
    filter->SetMemoryLimit(static_cast<vtkTypeInt64>(limit));
    Listener listener(filter);
    filter->Update();
    (filter->GetErrorCode() == vtkErrorCode::NoError ? accepted : refused) = limit;
  }
  return accepted;
}
}

TEST(EarthMoversMemory, IsPredicted)
{
  const auto surface = MakeTerrain(100);
  AddMasses(surface, "from", 700);
  AddMasses(surface, "to", 9000);
  for (const bool isDelaunay : { false, true })
  {
    vtkNew<vtkSurfaceEarthMoversDistance> filter;
    filter->SetInputData(surface);
    filter->SetFromArrayName("from");
    filter->SetToArrayName("to");
    filter->SetIntrinsicDelaunay(isDelaunay);
    filter->SetTolerance(0.0);
    filter->SetMaximumNumberOfIterations(25);
    filter->SetMemoryLimit(1000);
    ExpectError(filter, { "MemoryLimit" }); // the mesh and the matrix exist then
    filter->SetMemoryLimit(0);
    double peak = 0.0;
    {
      const MemoryProbe probe;
      ExpectWarning(filter, { "gap" });
      peak = static_cast<double>(probe.GetHeapPeak()); // 0 if it cannot be measured
    }
    filter->SetMaximumNumberOfIterations(0);
    const double predicted = FindLeastLimit(filter); // includes the system
    EXPECT_GE(predicted, peak) << isDelaunay;
    if (peak > 0.0)
    {
      EXPECT_LE(predicted, 2.5 * peak) << isDelaunay;
    }
  }
}
