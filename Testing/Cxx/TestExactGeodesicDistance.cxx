// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact distances through the filter: closed forms and invariants. The kernel has separate tests;
/// these tests verify the conversion from and to VTK.
#include "FilterTestTools.h"

#include "vtkExactGeodesicDistance.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(ExactGeodesicDistance, TakesIdsInBraces)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetSourceIds({ 0 }); // not a null list
  ASSERT_EQ(filter->GetNumberOfSourceIds(), 1);
  EXPECT_EQ(filter->GetSourceId(0), 0);
  filter->SetSourceIds({ 3, 5 });
  EXPECT_EQ(filter->GetNumberOfSourceIds(), 2);
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

TEST(ExactGeodesicDistance, PointsInTheMiddleOfFacesAndEdges)
{
  // From (0,0,0) to (1,1,1/2) on the unit cube; the target is inserted as a point on the edge.
  auto cube = MakeCube();
  const vtkIdType middle = cube->GetPoints()->InsertNextPoint(1.0, 1.0, 0.5);
  cube->SetPolys(MakeCells({ { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 0, 4, 6, 2 },
    { 2, 6, 7, middle, 3 }, { 1, 3, middle, 7, 5 } }));
  EXPECT_NEAR(Distances(cube, 0)[middle], std::sqrt(13.0) / 2.0, 1e-12);
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
