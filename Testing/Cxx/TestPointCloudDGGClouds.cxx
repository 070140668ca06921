// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: warnings and errors about clouds, and filters downstream. Graphs are tested
// with the kernel.
#include "PointCloudDGGFixture.h"

#include "vtkDGGDistance.h"
#include "vtkDGGPath.h"

#include <random>

namespace dggtest
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

Points Scale(Points points, double scale)
{
  for (auto& p : points)
  {
    p = { { scale * p[0], scale * p[1], scale * p[2] } };
  }
  return points;
}

}

TEST_F(PointCloudDGG, PointsThatAreNotFinite)
{
  Points points = MakeFlatPoints(15, 0.1);
  points[7][1] = NaN;
  points[100][0] = std::numeric_limits<double>::infinity();
  this->Use(points);
  ExpectWarning(this->Filter, { "2 points with a coordinate that is not finite" });
  EXPECT_EQ(this->Filter->GetNumberOfUnusedPoints(), 2);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(this->GetOutput());
  distance->SetSourceIds({ 0 });
  ExpectSuccess(distance);
  const std::vector<int> components = GetComponents(this->GetOutput());
  const std::vector<double> distances = GetDistances(distance);
  ASSERT_EQ(distances.size(), 225u);
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    const bool isUnused = i == 7 || i == 100;
    EXPECT_EQ(components[i], isUnused ? -1 : 0) << i;
    EXPECT_EQ(std::isnan(distances[i]), isUnused) << i;
  }
  distance->SetSourceIds({ 7 });
  ExpectWarning(distance, { "source id 7", "not finite", "reach no other point" });
  EXPECT_EQ(GetDistances(distance)[7], 0.0);
  EXPECT_TRUE(std::isnan(GetDistances(distance)[8]));
}

TEST_F(PointCloudDGG, NoPointIsFinite)
{
  this->Use(Points(5, { { NaN, 0.0, NaN } }));
  ExpectWarning(this->Filter, { "5 points with a coordinate that is not finite" });
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 0);
  EXPECT_EQ(GetComponents(this->GetOutput()), std::vector<int>(5, -1));
  for (const bool smooth : { false, true })
  {
    vtkNew<vtkDGGPath> path;
    path->SetInputData(this->GetOutput());
    path->SetStraighten(smooth);
    path->AddPair(0, 1);
    path->AddPair(2, 2); // not connected to itself either
    ExpectWarning(path, { "2 of 2 pairs", "No path in the graph of the cloud" });
    EXPECT_EQ(path->GetOutput()->GetNumberOfLines(), 0);
    vtkDataArray* status = path->GetOutput()->GetFieldData()->GetArray("PathStatus");
    ASSERT_NE(status, nullptr);
    EXPECT_EQ(status->GetTuple1(0), 1);
    EXPECT_EQ(status->GetTuple1(1), 1);
  }
}

TEST_F(PointCloudDGG, Outliers)
{
  for (const bool byPlanes : { false, true })
  {
    this->Filter->SetEstimateNormals(byPlanes);
    this->Use(Join(MakeSpherePoints(600), { { { 1e6, 0.5e6, -1e6 } } }));
    ExpectWarning(this->Filter, { "1 point more than 1000 times as far away" });
    EXPECT_EQ(this->Filter->GetNumberOfOutliers(), 1);
    EXPECT_EQ(this->Filter->GetNumberOfComponents(), 2);
    EXPECT_EQ(GetComponents(this->GetOutput())[600], 1);
  }
}

TEST_F(PointCloudDGG, WarnsOfNoiseThatIsLargeBesideTheShape)
{
  std::mt19937 generator(6);
  std::normal_distribution<double> number;
  Points points = MakeSpherePoints(1500);
  for (auto& p : points)
  {
    p = Scale({ p }, 1.0 + 0.1 * number(generator))[0];
  }
  this->Use(points);
  ExpectWarning(this->Filter,
    { "the noise of the points", "of the typical radius of curvature",
      "distances may be off by 1 % or more", "less noise" });
  EXPECT_GT(this->Filter->GetNoiseByRadius(), 0.07);
}

TEST_F(PointCloudDGG, VoxelsLargerThanTheSpacing)
{
  const Points clean = MakeSpherePoints(400);
  this->Use(clean);
  this->Filter->SetResolution(4);
  ExpectWarning(this->Filter,
    { "(Resolution 4), are larger than the spacing", "Building is slower",
      "Use a larger Resolution" });
  this->Filter->SetOffsetInVoxels(1.0);
  ExpectWarning(this->Filter, { "(Resolution 4), are larger", "The graph bridges gaps" });
  this->Filter->SetOffsetInVoxels(0.0);
  this->Filter->SetResolution(0);
  ExpectSuccess(this->Filter);
  // Distant points that are too many to be outliers.
  this->Use(Join(clean, Move(Scale(MakeSpherePoints(30), 2e3), { { 5e3, 0.0, 0.0 } })));
  ExpectWarning(
    this->Filter, { ", automatic), are larger than the spacing", "sparser than others" });
  EXPECT_EQ(this->Filter->GetComponentSize(0), 400);
}

TEST_F(PointCloudDGG, ExtentsOutOfRange)
{
  const Points part = MakeSpherePoints(100);
  for (const bool byPlanes : { false, true })
  {
    this->Filter->SetEstimateNormals(byPlanes);
    // Includes extents below the normal range of double.
    for (const double scale : { 1e-320, 1e-200, 1e200, 1e308 })
    {
      this->Use(Scale(part, scale));
      ExpectError(this->Filter, { "Scale" });
    }
    this->Use(Join(part, Move(part, { { 1e9, 0.0, 0.0 } })));
    ExpectError(
      this->Filter, { "too far apart", "1e+09 from the center", "process each part separately" });
  }
}
}
