// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkDGGDistance on point clouds.
#include "CloudFixture.h"

#include "vtkDGGDistance.h"
#include "vtkGeodesicSampler.h"

#include <cstddef>

namespace dggtest
{
namespace
{
class CloudDistance : public CloudFixture
{
};
}

TEST_F(CloudDistance, DistanceInThePlane)
{
  this->Use(MakeFlatPoints(50, 0.25));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceIds({ 1275 });
  ExpectSuccess(distance);
  EXPECT_TRUE(distance->GetUsedInputGraph());
  EXPECT_FALSE(distance->GetGraphIsGuaranteed());
  EXPECT_EQ(distance->GetNumberOfGraphEdges(), this->Graph->GetNumberOfGraphEdges());
  const std::vector<double> values = GetDistances(distance);
  std::vector<double> exact;
  for (const auto& p : this->Cloud)
  {
    exact.push_back(Distance(p, this->Cloud[1275]));
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_GE(values[i], exact[i] * (1.0 - 1e-6)) << i;
    EXPECT_LE(values[i], exact[i] * 1.02 + 1e-12) << i;
  }
  EXPECT_LT(GetMeanCloudError(values, exact), 2e-3);
}

TEST_F(CloudDistance, AccuracyIsNotUsed)
{
  this->Use(MakeFlatPoints(15, 0.2));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceIds({ 0 });
  distance->SetAccuracy(1e-5);
  distance->MergeCoincidentPointsOn();
  ExpectSuccess(distance);
}

TEST_F(CloudDistance, SourcesNearTheCloud)
{
  this->Use(MakeFlatPoints(40, 0.2));
  const std::array<double, 3> place{ { 0.4321, 0.5678, 0.0 } };
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceData(MakeSourcePoints({ place }));
  ExpectSuccess(distance);
  std::vector<double> exact;
  for (const auto& p : this->Cloud)
  {
    exact.push_back(Distance(p, place));
  }
  const std::vector<double> values = GetDistances(distance);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_GE(values[i], exact[i] * (1.0 - 1e-6)) << i;
    EXPECT_LE(values[i], exact[i] * 1.02 + 1e-12) << i;
  }
  EXPECT_LT(GetMeanCloudError(values, exact), 2e-3);

  // A source at a point of the cloud is identified with that point.
  distance->SetSourceData(MakeSourcePoints({ this->Cloud[77] }));
  ExpectSuccess(distance);
  const std::vector<double> atPoint = GetDistances(distance);
  distance->RemoveAllSources();
  distance->SetSourceIds({ 77 });
  ExpectSuccess(distance);
  EXPECT_EQ(GetDistances(distance), atPoint);
}

TEST_F(CloudDistance, NearestPointsAreTheNearest)
{
  // Comparison with a search of all points, also far outside the cloud and with coincident points.
  Points points = MakeSpherePoints(300);
  points = Join(points, { points[10], points[20], points[10] });
  this->Use(points);
  vtkNew<vtkGeodesicSampler> sampler;
  this->Connect(sampler);
  sampler->SetProjectionTolerance(10.0);
  sampler->SetNumberOfSamples(1);
  Points places = { points[302], points[301], { { 3.0, 0.1, 0.2 } }, { { -2.0, -2.5, 4.0 } },
    { { 0.0, 0.01, 0.02 } }, { { 0.3, -0.8, 0.4 } } };
  for (const auto& place : places)
  {
    sampler->SetStartData(MakeSourcePoints({ place }));
    ExpectSuccess(sampler);
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      nearest = Distance(points[i], place) < Distance(points[nearest], place) ? i : nearest;
    }
    EXPECT_EQ(
      Value(sampler->GetOutput()->GetPointData(), "vtkOriginalPointIds", 0), double(nearest));
  }
}

TEST_F(CloudDistance, VirtualSourcesNeedASurface)
{
  this->Use(MakeFlatPoints(10));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceIds({ 0 });
  distance->GenerateVirtualSourceOn();
  ExpectError(distance, { "point cloud", "Turn off GenerateVirtualSource" });
}
}
