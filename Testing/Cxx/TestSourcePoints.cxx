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
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace dggtest;

namespace
{
void ExpectEuclidean(
  vtkGeodesicDistanceAlgorithm* filter, vtkPolyData* plate, const std::array<double, 3>& source)
{
  const auto distances = GetDistances(filter);
  ASSERT_EQ(static_cast<vtkIdType>(distances.size()), plate->GetNumberOfPoints());
  for (vtkIdType i = 0; i < plate->GetNumberOfPoints(); ++i)
  {
    double p[3];
    plate->GetPoint(i, p);
    EXPECT_NEAR(distances[i], std::sqrt(vtkMath::Distance2BetweenPoints(p, source.data())), 1e-12)
      << i;
  }
}

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

TEST(SourcePoints, AtVerticesOnEdgesAndInsideFaces)
{
  auto grid = MakeGrid(5, 4);
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(grid);
  const Points places = { { { 2, 3, 0 } }, { { 2.5, 3, 0 } }, { { 2, 2.25, 0 } },
    { { 2.5, 2.5, 0 } }, { { 2.125, 1.25, 0 } }, { { 0, 0, 0 } }, { { 0, 1.5, 0 } },
    { { 4.9, 3.95, 0 } } };
  for (const auto& place : places)
  {
    SCOPED_TRACE(::testing::PrintToString(place));
    filter->SetSourceData(MakeSourcePoints({ place }));
    ExpectSuccess(filter);
    ExpectEuclidean(filter, grid, place);
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
  EXPECT_EQ(data->GetNumberOfArrays(), 4); // not the numbers of sources
  EXPECT_NEAR(GetDistances(filter)[3], 0.1, 1e-12);
  // Nearest to one, to the other, to an id, to none.
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

// Sources that are an outcome of this filter, with arrays that are not for the surface.
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
  heights->SetNumberOfTuples(3); // of 4 points
  heights->Fill(1.0);
  vtkNew<vtkFloatArray> coordinates; // without FaceId they are of no use
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

  // Another name: the array is not looked at, then it is.
  filter->SetSourceData(WithInitialDistances(places, { offsets[0], offsets[1] }, "Start"));
  ExpectSuccess(filter);
  const double none[2] = { 0.0, 0.0 };
  expectOffsets(none);
  filter->SetInitialDistanceArrayName("Start");
  ExpectSuccess(filter);
  expectOffsets(offsets);
}

TEST(SourcePoints, OnTrianglesWithoutArea)
{
  // A dangling triangle that is a doubled segment, and the plate that it hangs on.
  auto surface = MakeSurface(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 3, 0, 0 } }, { { 2, 0, 0 } } },
    { { 0, 1, 2 }, { 1, 3, 4 } });
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(surface);
  filter->SetSourceData(MakeSourcePoints({ { { 2.5, 0.0, 0.0 } } }));
  Listener listener(filter);
  filter->Update();
  EXPECT_EQ(listener.Errors, std::vector<std::string>());
  EXPECT_EQ(listener.Warnings.size(), 2u); // no area, and sheets that touch in a point
  EXPECT_EQ(filter->GetNumberOfDegenerateFaces(), 1);
  EXPECT_EQ(filter->GetNumberOfNonManifoldVertices(), 1);
  const auto distances = GetDistances(filter);
  EXPECT_NEAR(distances[4], 0.5, 1e-9);
  EXPECT_NEAR(distances[3], 0.5, 1e-9);
  EXPECT_NEAR(distances[0], 2.5, 1e-9);
  EXPECT_NEAR(distances[2], 1.5 + std::sqrt(2.0), 1e-9);
}
