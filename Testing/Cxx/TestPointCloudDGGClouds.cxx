// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: clouds that are not as they should be.
#include "PointCloudDGGFixture.h"

#include "vtkDGGDistance.h"
#include "vtkDGGPath.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace dggtest
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
}

TEST_F(PointCloudDGG, PointsThatAreNotFinite)
{
  Points points = MakeFlatPoints(15, 0.1);
  points[7][1] = NaN;
  points[100][0] = std::numeric_limits<double>::infinity();
  this->Use(points);
  ExpectWarning(this->Filter, { "2 points that are not finite" });
  EXPECT_EQ(this->Filter->GetNumberOfUnusedPoints(), 2);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  const std::vector<int> components = GetComponents(this->GetOutput());
  EXPECT_EQ(this->GetOutput()->GetNumberOfPoints(), 225);
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    EXPECT_EQ(components[i], i == 7 || i == 100 ? -1 : 0) << i;
  }
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(this->GetOutput());
  distance->SetSourceIds({ 0 });
  ExpectSuccess(distance);
  const std::vector<double> distances = GetDistances(distance);
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    EXPECT_EQ(std::isnan(distances[i]), i == 7 || i == 100) << i;
  }
  distance->SetSourceIds({ 7 });
  ExpectWarning(distance, { "source id 7", "not finite", "reach no other point" });
  const std::vector<double> nowhere = GetDistances(distance);
  EXPECT_EQ(nowhere[7], 0.0);
  EXPECT_TRUE(std::isnan(nowhere[8]));
}

TEST_F(PointCloudDGG, NoPointIsFinite)
{
  this->Use(Points(5, { { NaN, 0.0, NaN } }));
  ExpectWarning(this->Filter, { "5 points that are not finite" });
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 0);
  EXPECT_EQ(GetComponents(this->GetOutput()), std::vector<int>(5, -1));
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(this->GetOutput());
  distance->SetSourceIds({ 1 });
  ExpectWarning(distance, { "not finite", "reach no other point" });
  const std::vector<double> distances = GetDistances(distance);
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_EQ(std::isnan(distances[i]), i != 1) << i;
  }
  for (const bool smooth : { false, true })
  {
    vtkNew<vtkDGGPath> path;
    path->SetInputData(this->GetOutput());
    path->SetStraighten(smooth);
    path->AddPair(0, 1);
    path->AddPair(2, 2); // not connected to itself either
    ExpectWarning(path, { "2 of 2 pairs", "not connected by the graph of the cloud" });
    EXPECT_EQ(path->GetOutput()->GetNumberOfLines(), 0);
    vtkDataArray* status = path->GetOutput()->GetFieldData()->GetArray("PathStatus");
    ASSERT_NE(status, nullptr);
    EXPECT_EQ(status->GetTuple1(0), 1);
    EXPECT_EQ(status->GetTuple1(1), 1);
  }
}

TEST_F(PointCloudDGG, Outliers)
{
  const Points clean = MakeSpherePoints(600);
  vtkNew<vtkDGGPath> path;
  path->SetInputConnection(this->Filter->GetOutputPort());
  path->StraightenOn();
  path->AddPair(0, 400);
  const auto getLength = [&] {
    EXPECT_EQ(path->GetOutput()->GetNumberOfLines(), 1);
    return path->GetOutput()->GetCellData()->GetArray("Length")->GetTuple1(0);
  };
  for (const bool byPlanes : { false, true })
  {
    this->Filter->SetEstimateNormals(byPlanes);
    this->Use(clean);
    ExpectSuccess(path);
    const double length = getLength();
    const double voxel = this->Filter->GetVoxelSize();
    for (const double off : { 2e3, 1e6, 1e9 })
    {
      this->Use(Join(clean, { { { off, 0.5 * off, -off } } }));
      ExpectWarning(this->Filter, { "1 point that is more than 1000 times as far off" });
      EXPECT_EQ(this->Filter->GetNumberOfOutliers(), 1);
      EXPECT_EQ(this->Filter->GetNumberOfComponents(), 2);
      EXPECT_EQ(this->Filter->GetComponentSize(0), 600);
      EXPECT_EQ(GetComponents(this->GetOutput())[600], 1);
      EXPECT_EQ(this->Filter->GetVoxelSize(), voxel);
      ExpectSuccess(path);
      EXPECT_EQ(getLength(), length) << off;
    }
  }
  path->RemoveAllPairs();
  path->AddPair(0, 600);
  ExpectWarning(path, { "not connected by the graph of the cloud" });
}

TEST_F(PointCloudDGG, WarnsOfPointsOnNoSurface)
{
  this->Use(MakeVolumePoints(1500));
  ExpectWarning(this->Filter,
    { "% of the points do not lie on a surface", "times their spacing", "Thin the cloud out" });
  EXPECT_GT(this->Filter->GetOffSurfaceShare(), 0.5);
  EXPECT_GT(this->Filter->GetScatter(), 1.0);
  EXPECT_EQ(this->Filter->GetNoise(), 0.0);
  this->Use(MakeSpherePoints(600));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetOffSurfaceShare(), 0.0);
  EXPECT_EQ(this->Filter->GetScatter(), 0.0);
}

TEST_F(PointCloudDGG, WarnsOfNoiseThatIsLargeBesideTheShape)
{
  std::mt19937 generator(6);
  std::normal_distribution<double> number;
  for (const double noise : { 0.1, 0.03 })
  {
    Points points = MakeSpherePoints(1500);
    for (auto& p : points)
    {
      const double radius = 1.0 + noise * number(generator);
      p = { { radius * p[0], radius * p[1], radius * p[2] } };
    }
    this->Use(points);
    if (noise > 0.05)
    {
      ExpectWarning(this->Filter,
        { "the noise of the points", "of the radius at which the surface typically bends",
          "distances may be wrong by 1 % or more", "less noisy" });
      EXPECT_GT(this->Filter->GetNoiseByRadius(), 0.07);
    }
    else
    {
      ExpectSuccess(this->Filter);
      EXPECT_GT(this->Filter->GetNoiseByRadius(), 0.01);
    }
  }
}

TEST_F(PointCloudDGG, PartsThatAreTooFarApart)
{
  const Points part = MakeSpherePoints(300);
  this->Use(Join(part, Move(part, { { 1e9, 0.0, 0.0 } })));
  ExpectError(this->Filter, { "too far apart", "1e+09 from the middle", "each part on its own" });
  ExpectEmptyOutput(this->Filter);
  this->Use(Join(part, Move(part, { { 1e4, 0.0, 0.0 } })));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 2);
  EXPECT_EQ(this->Filter->GetComponentSize(1), 300);
}

TEST_F(PointCloudDGG, VoxelsLargerThanTheSpacing)
{
  const Points clean = MakeSpherePoints(400);
  this->Use(clean);
  this->Filter->SetResolution(4);
  ExpectWarning(this->Filter,
    { "(Resolution 4), are larger than the spacing", "Building is slower",
      "Use a larger Resolution" });
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  this->Filter->SetOffsetInVoxels(1.0);
  ExpectWarning(this->Filter, { "(Resolution 4), are larger", "The graph bridges gaps" });
  this->Filter->SetOffsetInVoxels(0.0);
  this->Filter->SetResolution(0);
  ExpectSuccess(this->Filter);
  vtkNew<vtkDGGPath> path;
  path->SetInputConnection(this->Filter->GetOutputPort());
  path->StraightenOn();
  path->AddPair(0, 300);
  ExpectSuccess(path);
  const auto getLength = [&] {
    return path->GetOutput()->GetCellData()->GetArray("Length")->GetTuple1(0);
  };
  const double length = getLength();

  // Points far off that are too many to be outliers.
  Points few = MakeSpherePoints(30);
  for (auto& point : few)
  {
    point = { { 5e3 + 2e3 * point[0], 2e3 * point[1], 2e3 * point[2] } };
  }
  this->Use(Join(clean, few));
  ExpectWarning(
    this->Filter, { ", automatic), are larger than the spacing", "sparser than others" });
  EXPECT_EQ(this->Filter->GetComponentSize(0), 400);
  ExpectSuccess(path);
  EXPECT_NEAR(getLength(), length, 0.01 * length); // not through the sphere
}

TEST_F(PointCloudDGG, ExtentsOutOfRange)
{
  // Also where the extent itself is below the normal range of double.
  for (const double scale : { 1e-320, 1e-200, 1e200, 1e308 })
  {
    Points points = MakeSpherePoints(100);
    for (auto& p : points)
    {
      p = { { scale * p[0], scale * p[1], scale * p[2] } };
    }
    this->Use(points);
    for (const bool byPlanes : { false, true })
    {
      this->Filter->SetEstimateNormals(byPlanes);
      ExpectError(this->Filter, { "scale them" });
    }
  }
}

TEST_F(PointCloudDGG, EmptyInput)
{
  this->Filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  ExpectWarning(this->Filter, { "input is empty" });
  EXPECT_EQ(this->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 0);
}
}
