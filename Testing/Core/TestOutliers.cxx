// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggOutliers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{
using dgg::Id;
using dgg::Outliers;
using dgg::Point3;

constexpr double Infinite = std::numeric_limits<double>::infinity();

/// An 11 x 11 grid over [-1, 1] x [-1, 1]: its middle is the origin, its farthest points are at 1.
std::vector<double> Grid()
{
  std::vector<double> points;
  for (int i = -5; i <= 5; ++i)
  {
    for (int j = -5; j <= 5; ++j)
    {
      points.insert(points.end(), { 0.2 * i, 0.2 * j, 0.0 });
    }
  }
  return points;
}

void Add(std::vector<double>& points, const Point3& p)
{
  points.insert(points.end(), { p.X, p.Y, p.Z });
}

Id CountStray(const std::vector<double>& points)
{
  return Outliers(points.data(), static_cast<Id>(points.size() / 3)).GetNumberOfPoints();
}
}

TEST(Outliers, AreAThousandTimesAsFarAsAllOthers)
{
  // The corners are the farthest of the others, at the root of 2.
  std::vector<double> points = Grid();
  EXPECT_EQ(CountStray(points), 0);
  Add(points, { 0.0, 0.0, 1410.0 });
  EXPECT_EQ(CountStray(points), 0);
  points.back() = 1420.0;
  const Outliers stray(points.data(), static_cast<Id>(points.size() / 3));
  EXPECT_EQ(stray.GetNumberOfPoints(), 1);
  EXPECT_TRUE(stray.IsOutlier({ 0.0, 0.0, 1420.0 }));
  EXPECT_TRUE(stray.IsOutlier({ -1420.0, 0.0, 0.0 }));
  EXPECT_FALSE(stray.IsOutlier({ 1.0, -1.0, 0.0 }));
  // From the gap on all are stray, however close to each other.
  Add(points, { 0.0, 0.0, 1500.0 });
  Add(points, { 0.0, -1e300, 5.0 });
  EXPECT_EQ(CountStray(points), 3);
  // One between them and the others closes the gap.
  Add(points, { 30.0, 0.0, 0.0 });
  EXPECT_EQ(CountStray(points), 1);
}

TEST(Outliers, RatioCanBeGiven)
{
  std::vector<double> points = Grid();
  Add(points, { 0.0, 0.0, 6.0 });
  const auto count = [&](double ratio) {
    return Outliers(points.data(), static_cast<Id>(points.size() / 3), ratio).GetNumberOfPoints();
  };
  EXPECT_EQ(count(Outliers::RatioOfFar), 1);
  EXPECT_EQ(count(4.3), 0);
}

TEST(Outliers, AreThoseOfATurnedCloud)
{
  // In any direction: the largest distance along an axis would be shorter along a diagonal.
  for (const double length : { 1410.0, 1420.0 })
  {
    for (int i = 0; i < 24; ++i)
    {
      const double angle = 0.3 * i;
      std::vector<double> points = Grid();
      Add(points, { length * std::cos(angle), length * std::sin(angle), 0.0 });
      EXPECT_EQ(CountStray(points), length > 1415.0 ? 1 : 0) << angle;
      points.end()[-3] = length * std::cos(angle) / std::sqrt(2.0);
      points.end()[-2] = length * std::cos(angle) / std::sqrt(2.0);
      points.end()[-1] = length * std::sin(angle);
      EXPECT_EQ(CountStray(points), length > 1415.0 ? 1 : 0) << angle;
    }
  }
}

TEST(Outliers, AreNoSmallObjectsNorEvenlySpread)
{
  // 16 places as far as 8 sides of the square.
  std::vector<double> points = Grid();
  for (int i = 0; i < 16; ++i)
  {
    Add(points, { 16.0 + 0.1 * (i % 4), 0.1 * (i / 4), 0.0 });
  }
  EXPECT_EQ(CountStray(points), 0);
  for (const int count : { 18, 25, 40 })
  {
    std::vector<double> spread;
    for (int i = 0; i < count; ++i)
    {
      const double radius = std::pow(5.0, i);
      Add(spread, { radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), 0.0 });
    }
    EXPECT_EQ(CountStray(spread), 0) << count;
  }
}

TEST(Outliers, AreInFewPlaces)
{
  std::vector<double> points = Grid();
  for (int i = 0; i < 16; ++i)
  {
    Add(points, { 1e6, 1.0 * i, 0.0 });
  }
  EXPECT_EQ(CountStray(points), 16);
  for (int i = 0; i < 40; ++i)
  {
    Add(points, { 1e6, 3.0, 0.0 });
  }
  EXPECT_EQ(CountStray(points), 56);
  Add(points, { 1e6, -1.0, 0.0 });
  EXPECT_EQ(CountStray(points), 0);
}

TEST(Outliers, NeedACloudToBeFarFrom)
{
  std::vector<double> points;
  EXPECT_EQ(CountStray(points), 0);
  for (int i = 0; i < 16; ++i)
  {
    Add(points, { 0.1 * i, 0.0, 0.0 });
  }
  Add(points, { 1e6, 0.0, 0.0 });
  Add(points, { 2e6, 0.0, 0.0 });
  EXPECT_EQ(CountStray(points), 0); // 16 places
  for (int i = 0; i < 30; ++i)
  {
    Add(points, { 0.5, 0.0, 0.0 });
  }
  EXPECT_EQ(CountStray(points), 0); // they still are
  Add(points, { 0.55, 0.0, 0.0 });
  EXPECT_EQ(CountStray(points), 2);
  // The nearest gap counts that leaves enough.
  std::vector<double> few;
  for (int i = 0; i < 16; ++i)
  {
    Add(few, { 0.1 * i, 0.0, 0.0 });
  }
  Add(few, { 1e4, 0.0, 0.0 });
  Add(few, { 1e8, 0.0, 0.0 });
  EXPECT_EQ(CountStray(few), 1);
}

TEST(Outliers, PointsThatAreNotFiniteDoNotCount)
{
  std::vector<double> points = Grid();
  for (int i = 0; i < 200; ++i)
  {
    Add(points, { std::nan(""), 0.0, 0.0 });
    Add(points, { 0.0, i % 2 == 0 ? Infinite : -Infinite, 0.0 });
  }
  EXPECT_EQ(CountStray(points), 0);
  Add(points, { 0.0, 1e308, -1e308 });
  EXPECT_EQ(CountStray(points), 1);
  const double most = std::numeric_limits<double>::max();
  Add(points, { -most, most, -most });
  EXPECT_EQ(CountStray(points), 2);
}
