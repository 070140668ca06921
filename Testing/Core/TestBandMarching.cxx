// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Benchmark/BandMarching.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{
using dgg::BandMarching;
using dgg::BandSource;
using dgg::Point3;
using dgg::VoxelBand;

struct Cloud
{
  std::vector<Point3> Points;
  std::vector<double> Radii;
};

/// A square of n x n points with sides of length 1, in a slanted plane, at a height.
void AddSquare(Cloud& cloud, int n, double height, double radius)
{
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double x = static_cast<double>(i) / (n - 1);
      const double y = static_cast<double>(j) / (n - 1);
      cloud.Points.push_back({ x, 0.8 * y - 0.6 * height, 0.6 * y + 0.8 * height });
      cloud.Radii.push_back(radius);
    }
  }
}

/// Mean relative error of distances from the first point, and that of straight ones when there is
/// no other truth.
double MeanError(const Cloud& cloud, double voxelSize)
{
  VoxelBand band;
  EXPECT_TRUE(band.Build(cloud.Points, cloud.Radii, voxelSize, 0, {}).IsOk());
  const BandMarching marching(band);
  std::vector<double> distances;
  EXPECT_TRUE(marching.Run({ { cloud.Points[0], 0.0 } }, cloud.Points, {}, distances).IsOk());
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 1; i < cloud.Points.size(); ++i)
  {
    const double truth = dgg::Norm(cloud.Points[i] - cloud.Points[0]);
    if (truth > 0.2)
    {
      sum += std::abs(distances[i] - truth) / truth;
      ++count;
    }
  }
  return sum / count;
}
}

TEST(BandMarching, PlaneConvergesToFirstOrder)
{
  Cloud cloud;
  AddSquare(cloud, 60, 0.0, 0.03);
  const double coarse = MeanError(cloud, 0.02);
  const double fine = MeanError(cloud, 0.01);
  EXPECT_LT(coarse, 0.08);
  EXPECT_LT(fine, 0.7 * coarse);
}

TEST(BandMarching, SheetsThatDoNotTouchStayApart)
{
  Cloud cloud;
  AddSquare(cloud, 40, 0.0, 0.04);
  AddSquare(cloud, 40, 0.12, 0.04);
  VoxelBand band;
  ASSERT_TRUE(band.Build(cloud.Points, cloud.Radii, 0.01, 0, {}).IsOk());
  const BandMarching marching(band);
  std::vector<double> distances;
  ASSERT_TRUE(marching.Run({ { cloud.Points[7], 0.0 } }, cloud.Points, {}, distances).IsOk());
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    EXPECT_EQ(distances[i] < dgg::Infinity, i < 1600U) << i;
  }
}

TEST(BandMarching, OffsetsAndTheNearestSource)
{
  Cloud cloud;
  AddSquare(cloud, 40, 0.0, 0.05);
  VoxelBand band;
  ASSERT_TRUE(band.Build(cloud.Points, cloud.Radii, 0.02, 0, {}).IsOk());
  const BandMarching marching(band);
  const Point3 a = cloud.Points[0];
  const Point3 b = cloud.Points.back();
  std::vector<double> both;
  std::vector<double> first;
  std::vector<double> second;
  ASSERT_TRUE(marching.Run({ { a, 0.25 }, { b, 0.0 } }, cloud.Points, {}, both).IsOk());
  ASSERT_TRUE(marching.Run({ { a, 0.25 } }, cloud.Points, {}, first).IsOk());
  ASSERT_TRUE(marching.Run({ { b, 0.0 } }, cloud.Points, {}, second).IsOk());
  for (std::size_t i = 0; i < both.size(); ++i)
  {
    EXPECT_NEAR(both[i], std::min(first[i], second[i]), 0.03) << i;
  }
  EXPECT_NEAR(first[0], 0.25, 0.02);
}

TEST(BandMarching, RefusesBadSources)
{
  Cloud cloud;
  AddSquare(cloud, 10, 0.0, 0.1);
  VoxelBand band;
  ASSERT_TRUE(band.Build(cloud.Points, cloud.Radii, 0.05, 0, {}).IsOk());
  const BandMarching marching(band);
  std::vector<double> distances{ 1.0 };
  EXPECT_FALSE(marching.Run({}, cloud.Points, {}, distances).IsOk());
  EXPECT_TRUE(distances.empty());
  EXPECT_FALSE(marching.Run({ { { 0.5, 0.4, 5.0 }, 0.0 } }, cloud.Points, {}, distances).IsOk());
  EXPECT_FALSE(
    marching.Run({ { { std::nan(""), 0.0, 0.0 }, 0.0 } }, cloud.Points, {}, distances).IsOk());
  EXPECT_TRUE(
    marching
      .Run(
        { { cloud.Points[0], 0.0 } }, cloud.Points, [](double) { return false; }, distances)
      .IsAborted());
  // Places off the band are not reached.
  ASSERT_TRUE(marching
                .Run({ { cloud.Points[0], 0.0 } },
                  { { 9.0, 9.0, 9.0 }, { std::nan(""), 0.0, 0.0 } }, {}, distances)
                .IsOk());
  EXPECT_EQ(distances[0], dgg::Infinity);
  EXPECT_EQ(distances[1], dgg::Infinity);
}
