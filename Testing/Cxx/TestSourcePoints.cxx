// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sources on input port 1: anywhere on the surface, with initial distances.
#include "FilterTestTools.h"

#include "vtkExactGeodesicDistance.h"

using namespace dggtest;

namespace
{
vtkSmartPointer<vtkPolyData> WithInitialDistances(
  const Points& points, const std::vector<double>& values, const char* name = "InitialDistance")
{
  auto data = MakeSourcePoints(points);
  AddArray(data->GetPointData(), name, values);
  return data;
}
}

TEST(SourcePoints, ArraysOfTheNearest)
{
  auto sources = MakeSourcePoints({ { { 3.1, 0.0, 0.0 } }, { { 6.1, 0.0, 0.0 } } });
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  names->InsertNextValue("west");
  names->InsertNextValue("east");
  vtkPointData* given = sources->GetPointData();
  given->AddArray(names);
  AddArray<vtkIntArray>(given, "Label", { 7, 9 });
  AddArray<vtkFloatArray>(given, "Color", { 1, 2, 3, 4 }, 2);
  AddArray<vtkFloatArray>(given, "GeodesicDistance", { 0, 0 }); // the name is taken
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
  vtkPointData* given = sources->GetPointData();
  AddArray<vtkUnsignedCharArray>(given, vtkDataSetAttributes::GhostArrayName(), { 1, 1, 1, 1 });
  AddArray(given, "Height", { 1, 1, 1 });                          // the surface has 4 points
  AddArray(given, "Barycentric", std::vector<double>(12, 1.0), 3); // ignored without FaceId

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
  EXPECT_EQ(GetDistances(filter)[0], 0.0);
  filter->SetInitialDistanceArrayName("Start");
  ExpectSuccess(filter);
  expectOffsets(offsets);
}
