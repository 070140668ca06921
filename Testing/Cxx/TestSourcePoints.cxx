// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sources on input port 1: anywhere on the surface, with initial distances.
#include "FilterTestTools.h"

#include "vtkExactGeodesicDistance.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace dggtest;

namespace
{
vtkSmartPointer<vtkPolyData> WithInitialDistances(
  const Points& points, const std::vector<double>& values, const char* name = "InitialDistance")
{
  auto data = MakeSourcePoints(points);
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetPointData()->AddArray(array);
  return data;
}
}

TEST(SourcePoints, NumberingIsIdsFirst)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(MakeGrid(9, 1));
  filter->SetSourceIds(std::vector<vtkIdType>{ 9, 0 });
  filter->SetSourceData(MakeSourcePoints({ { { 3.1, 0.0, 0.0 } }, { { 6.1, 0.0, 0.0 } } }));
  filter->GenerateNearestSourceOn();
  ExpectSuccess(filter);
  const auto sources = GetNearestSources(filter);
  ASSERT_EQ(sources.size(), 20u);
  EXPECT_EQ(sources[9], 0);
  EXPECT_EQ(sources[0], 1);
  EXPECT_EQ(sources[3], 2);
  EXPECT_EQ(sources[6], 3);
  EXPECT_NEAR(GetDistances(filter)[3], 0.1, 1e-12);
}

TEST(SourcePoints, ArraysOfTheNearest)
{
  auto sources = MakeSourcePoints({ { { 3.1, 0.0, 0.0 } }, { { 6.1, 0.0, 0.0 } } });
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  names->InsertNextValue("west");
  names->InsertNextValue("east");
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  labels->InsertNextValue(7);
  labels->InsertNextValue(9);
  vtkNew<vtkFloatArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(2);
  colors->InsertNextTuple2(1.0, 2.0);
  colors->InsertNextTuple2(3.0, 4.0);
  vtkNew<vtkFloatArray> taken;
  taken->SetName("GeodesicDistance");
  taken->SetNumberOfTuples(2);
  for (vtkAbstractArray* array : std::vector<vtkAbstractArray*>{ names, labels, colors, taken })
  {
    sources->GetPointData()->AddArray(array);
  }
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(MakeGrid(9, 1));
  filter->AddSourceId(9);
  filter->SetSourceData(sources);
  filter->SetMaximumDistance(1.5);
  filter->PassSourceArraysOn();
  ExpectSuccess(filter);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 4); // indices of sources are not passed
  EXPECT_NEAR(GetDistances(filter)[3], 0.1, 1e-12);
  // Points nearest to the first source, to the second source, to an id, to none.
  const vtkIdType points[4] = { 3, 6, 9, 0 };
  const std::string expectedNames[4] = { "west", "east", "", "" };
  const double expectedLabels[4] = { 7.0, 9.0, 0.0, 0.0 };
  const double expectedColors[4] = { 2.0, 4.0, std::nan(""), std::nan("") };
  auto found = vtkStringArray::SafeDownCast(data->GetAbstractArray("Name"));
  ASSERT_NE(found, nullptr);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(found->GetValue(points[i]), expectedNames[i]);
    EXPECT_EQ(data->GetArray("Label")->GetTuple1(points[i]), expectedLabels[i]);
    const double color = data->GetArray("Color")->GetComponent(points[i], 1);
    EXPECT_TRUE(color == expectedColors[i] || (std::isnan(color) && i > 1)) << color;
  }
}

// Sources from an output of the same filter, with arrays that are not passed to the surface.
TEST(SourcePoints, ArraysThatAreNotPassed)
{
  vtkNew<vtkExactGeodesicDistance> before;
  before->SetInputData(MakeGrid(1, 1));
  before->AddSourceId(0);
  before->SetMaximumDistance(0.5);
  before->SetUnreachedValue(-1.0);
  before->GenerateVirtualSourceOn();
  before->GenerateNearestSourceOn();
  ExpectSuccess(before);
  vtkNew<vtkPolyData> sources;
  sources->ShallowCopy(before->GetOutput());
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(4);
  ghosts->Fill(1.0);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Height");
  heights->SetNumberOfTuples(3); // the surface has 4 points
  heights->Fill(1.0);
  vtkNew<vtkFloatArray> coordinates; // ignored without FaceId
  coordinates->SetName("Barycentric");
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(4);
  coordinates->Fill(1.0);
  sources->GetPointData()->AddArray(coordinates);
  sources->GetPointData()->AddArray(ghosts);
  sources->GetPointData()->AddArray(heights);

  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(MakeGrid(9, 1));
  filter->SetSourceData(sources);
  filter->PassSourceArraysOn();
  ExpectSuccess(filter);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  ASSERT_EQ(data->GetNumberOfArrays(), 1);
  EXPECT_NEAR(GetDistances(filter)[9], 8.0, 1e-12);
}

TEST(SourcePoints, InitialDistances)
{
  auto grid = MakeGrid(8, 2);
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(grid);
  filter->GenerateNearestSourceOn();
  const Points places = { { { 0, 0, 0 } }, { { 7.5, 1.5, 0 } } };
  const double offsets[2] = { 1.5, -0.25 };
  filter->SetSourceData(WithInitialDistances(places, { offsets[0], offsets[1] }));
  ExpectSuccess(filter);
  auto expectOffsets = [&](const double* start) {
    const auto distances = GetDistances(filter);
    const auto sources = GetNearestSources(filter);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      double p[3];
      grid->GetPoint(i, p);
      double d[2];
      for (int k = 0; k < 2; ++k)
      {
        d[k] = start[k] + std::sqrt(vtkMath::Distance2BetweenPoints(p, places[k].data()));
      }
      EXPECT_NEAR(distances[i], std::min(d[0], d[1]), 1e-12) << i;
      EXPECT_NEAR(d[sources[i]], distances[i], 1e-12) << i;
    }
  };
  expectOffsets(offsets);

  // An array with another name is ignored until the name is set.
  filter->SetSourceData(WithInitialDistances(places, { offsets[0], offsets[1] }, "Start"));
  ExpectSuccess(filter);
  const double none[2] = { 0.0, 0.0 };
  expectOffsets(none);
  filter->SetInitialDistanceArrayName("Start");
  ExpectSuccess(filter);
  expectOffsets(offsets);
}
