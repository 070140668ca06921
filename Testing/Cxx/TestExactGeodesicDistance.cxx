// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact distances through the filter: closed forms and invariants. The kernel has separate tests;
/// these tests verify the conversion from and to VTK.
#include "FilterTestTools.h"

#include "vtkExactGeodesicDistance.h"

using namespace dggtest;

namespace
{
std::vector<double> Distances(
  vtkPolyData* surface, vtkIdType source, int engine = vtkExactGeodesicDistance::Triangle)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(surface);
  filter->AddSourceId(source);
  filter->SetEngine(engine);
  ExpectSuccess(filter);
  return GetDistances(filter);
}
}

TEST(ExactGeodesicDistance, Cube)
{
  for (const int engine :
    { vtkExactGeodesicDistance::Reference, vtkExactGeodesicDistance::Triangle })
  {
    const auto distances = Distances(MakeCube(), 0, engine);
    const double expected[8] = { 0.0, 1.0, 1.0, std::sqrt(2.0), 1.0, std::sqrt(2.0), std::sqrt(2.0),
      std::sqrt(5.0) };
    for (int i = 0; i < 8; ++i)
    {
      EXPECT_NEAR(distances[i], expected[i], 1e-12) << i;
    }
  }
}

TEST(ExactGeodesicDistance, FloatAndDoublePointsAgree)
{
  auto terrain = MakeTerrain(15);
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  vtkNew<vtkPoints> doubles;
  doubles->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < terrain->GetNumberOfPoints(); ++i)
  {
    double p[3];
    terrain->GetPoint(i, p);
    floats->InsertNextPoint(p);
    floats->GetPoint(i, p); // rounded to single precision
    doubles->InsertNextPoint(p);
  }
  terrain->SetPoints(floats);
  const auto fromFloats = Distances(terrain, 40);
  terrain->SetPoints(doubles);
  EXPECT_EQ(Distances(terrain, 40), fromFloats);
}
