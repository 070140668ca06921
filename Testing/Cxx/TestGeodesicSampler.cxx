// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Samples of surfaces by the filter.
#include "GraphTestTools.h"

#include "vtkGeodesicSampler.h"

using namespace dggtest;

namespace
{
std::vector<double> GetArray(vtkGeodesicSampler* filter, const char* name)
{
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(name);
  std::vector<double> values;
  EXPECT_NE(array, nullptr) << name;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

std::vector<vtkIdType> GetIds(vtkGeodesicSampler* filter)
{
  const std::vector<double> values = GetArray(filter, "vtkOriginalPointIds");
  return { values.begin(), values.end() };
}

class GeodesicSampler : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(this->Terrain);
    this->Filter->SetAccuracy(0.05);
    this->Filter->SetNumberOfSamples(12);
  }

  vtkSmartPointer<vtkPolyData> Terrain = MakeTerrain(20);
  vtkNew<vtkGeodesicSampler> Filter;
};
}

TEST_F(GeodesicSampler, SamplesArePointsOfTheInput)
{
  ExpectSuccess(this->Filter);
  vtkPolyData* output = this->Filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 12);
  EXPECT_EQ(output->GetNumberOfVerts(), 12);
  const std::vector<vtkIdType> ids = GetIds(this->Filter);
  EXPECT_EQ(std::set<vtkIdType>(ids.begin(), ids.end()).size(), ids.size());
  const std::vector<double> faces = GetArray(this->Filter, "FaceId");
  for (vtkIdType i = 0; i < 12; ++i)
  {
    double p[3];
    double q[3];
    output->GetPoint(i, p);
    this->Terrain->GetPoint(ids[i], q);
    EXPECT_TRUE(std::equal(p, p + 3, q));
    EXPECT_TRUE(this->Terrain->IsPointUsedByCell(ids[i], static_cast<vtkIdType>(faces[i])));
  }
}

TEST_F(GeodesicSampler, FirstSample)
{
  this->Filter->SetFirstSample(77);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetIds(this->Filter)[0], 77);
}

TEST_F(GeodesicSampler, StopsAtARadius)
{
  this->Filter->SetNumberOfSamples(400);
  this->Filter->SetCoveringRadius(0.3);
  ExpectSuccess(this->Filter);
  const std::vector<double> radii = GetArray(this->Filter, "CoveringRadius");
  ASSERT_GT(radii.size(), 2u);
  EXPECT_LE(radii.back(), 0.3);
  EXPECT_GT(radii[radii.size() - 2], 0.3);
}

TEST_F(GeodesicSampler, InFaces)
{
  ExpectSuccess(this->Filter);
  this->Filter->InFacesOn();
  ExpectSuccess(this->Filter);
  const std::vector<vtkIdType> ids = GetIds(this->Filter);
  EXPECT_GE(std::count(ids.begin(), ids.end(), -1), 3);
  const std::vector<double> radii = GetArray(this->Filter, "CoveringRadius");
  EXPECT_TRUE(std::is_sorted(radii.rbegin(), radii.rend()));
  // Samples lie on the surface, in the cells that FaceId names.
  vtkPolyData* output = this->Filter->GetOutput();
  const std::vector<double> faces = GetArray(this->Filter, "FaceId");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double bounds[6];
    double p[3];
    this->Terrain->GetCellBounds(static_cast<vtkIdType>(faces[i]), bounds);
    output->GetPoint(i, p);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_GE(p[k], bounds[2 * k] - 1e-12);
      EXPECT_LE(p[k], bounds[2 * k + 1] + 1e-12);
    }
  }
}

TEST_F(GeodesicSampler, StartPoints)
{
  const auto sheet = MakeGrid(8, 6);
  const auto start = MakeSourcePoints({ { { 2.3, 1.1, 0.0 } }, { { 4.0, 3.0, 0.01 } } });
  this->Filter->SetInputData(sheet);
  this->Filter->SetStartData(start);
  this->Filter->SetFirstSample(1000); // ignored
  ExpectSuccess(this->Filter);
  vtkPolyData* output = this->Filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 12);
  EXPECT_NEAR(output->GetPoint(0)[0], 2.3, 1e-9);
  EXPECT_NEAR(output->GetPoint(0)[1], 1.1, 1e-9);
  EXPECT_EQ(GetIds(this->Filter)[0], -1);
  EXPECT_EQ(GetIds(this->Filter)[1], 3 * 9 + 4);
  // All start points are kept.
  this->Filter->SetNumberOfSamples(1);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 2);
  this->Filter->SetStartData(nullptr);
  this->Filter->SetFirstSample(3);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 1);
}

TEST_F(GeodesicSampler, MoreSamplesThanPoints)
{
  this->Filter->SetInputData(MakeGrid(3, 2));
  this->Filter->SetNumberOfSamples(13);
  ExpectWarning(this->Filter, { "NumberOfSamples is 13", "after 12 samples", "subdivide" });
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 12);
  EXPECT_EQ(GetArray(this->Filter, "CoveringRadius").back(), 0.0);
  this->Filter->SetNumberOfSamples(12);
  ExpectSuccess(this->Filter);
  // Inside faces more samples are possible.
  this->Filter->SetNumberOfSamples(40);
  this->Filter->InFacesOn();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 40);
  const std::vector<double> radii = GetArray(this->Filter, "CoveringRadius");
  EXPECT_TRUE(std::is_sorted(radii.rbegin(), radii.rend()));
}
