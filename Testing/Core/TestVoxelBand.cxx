// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVoxelBand.h"

#include "GraphChecks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{
using dgg::Point3;
using dgg::Voxel;
using dgg::VoxelBand;

struct Balls
{
  std::vector<Point3> Centres;
  std::vector<double> Radii;
};

Balls RandomBalls(int count, double extent, double least, double most)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> place(-extent, extent);
  std::uniform_real_distribution<double> radius(least, most);
  Balls balls;
  for (int i = 0; i < count; ++i)
  {
    balls.Centres.push_back({ place(generator), place(generator), place(generator) });
    balls.Radii.push_back(radius(generator));
  }
  return balls;
}

bool IsInBall(const Balls& balls, const Point3& place, double margin)
{
  for (std::size_t i = 0; i < balls.Centres.size(); ++i)
  {
    if (dgg::Norm(place - balls.Centres[i]) <= balls.Radii[i] + margin)
    {
      return true;
    }
  }
  return false;
}
}

TEST(VoxelBand, MarksVoxelsWithCentresInBalls)
{
  const Balls balls = RandomBalls(40, 3.0, 0.1, 0.9);
  VoxelBand band;
  ASSERT_TRUE(band.Build(balls.Centres, balls.Radii, 0.1, 0, {}).IsOk());
  std::size_t marked = 0;
  const std::int32_t n = band.GetResolution();
  for (std::int32_t z = 0; z < n; ++z)
  {
    for (std::int32_t y = 0; y < n; ++y)
    {
      for (std::int32_t x = 0; x < n; ++x)
      {
        const Voxel voxel{ { x, y, z } };
        const bool isMarked = band.Contains(voxel);
        marked += isMarked ? 1 : 0;
        const Point3 centre = band.GetCentre(voxel);
        if (IsInBall(balls, centre, -1e-9))
        {
          ASSERT_TRUE(isMarked) << x << " " << y << " " << z;
        }
        else if (!IsInBall(balls, centre, 1e-9))
        {
          ASSERT_FALSE(isMarked) << x << " " << y << " " << z;
        }
      }
    }
  }
  EXPECT_GT(marked, 1000U);
  EXPECT_EQ(band.GetNumberOfVoxels(), marked);
}

TEST(VoxelBand, SmallBallsMarkTheirVoxelAndItsNeighbours)
{
  VoxelBand band;
  ASSERT_TRUE(band.Build({ { 0.5, 0.5, 0.5 } }, { 0.01 }, 1.0, 0, {}).IsOk());
  EXPECT_EQ(band.GetNumberOfVoxels(), 7U);
  ASSERT_TRUE(band.Build({ { 0.5, 0.5, 0.5 } }, { 0.0 }, 1.0, 0, {}).IsOk());
  EXPECT_EQ(band.GetNumberOfVoxels(), 7U);
}

TEST(VoxelBand, SameForAnyThreads)
{
  const Balls balls = RandomBalls(2000, 1.0, 0.02, 0.1);
  VoxelBand one;
  VoxelBand many;
  ASSERT_TRUE(one.Build(balls.Centres, balls.Radii, 0.02, 0, {}).IsOk());
  ASSERT_TRUE(many.Build(balls.Centres, balls.Radii, 0.02, 0, dggtest::WithThreads(4)).IsOk());
  ASSERT_EQ(one.GetNumberOfBricks(), many.GetNumberOfBricks());
  EXPECT_EQ(one.GetNumberOfVoxels(), many.GetNumberOfVoxels());
  const std::int32_t n = one.GetResolution();
  for (std::int32_t z = 0; z < n; z += 3)
  {
    for (std::int32_t y = 0; y < n; y += 3)
    {
      for (std::int32_t x = 0; x < n; ++x)
      {
        ASSERT_EQ(one.Contains({ { x, y, z } }), many.Contains({ { x, y, z } }));
      }
    }
  }
}

TEST(VoxelBand, SegmentsStayInside)
{
  // Two groups of balls, 3 radii apart.
  std::vector<Point3> centres;
  std::vector<double> radii;
  for (int i = 0; i <= 20; ++i)
  {
    centres.push_back({ 0.1 * i, 0.0, 0.0 });
    centres.push_back({ 0.1 * i, 0.0, 0.9 });
  }
  radii.assign(centres.size(), 0.3);
  VoxelBand band;
  ASSERT_TRUE(band.Build(centres, radii, 0.05, 0, {}).IsOk());
  const auto has = [&](const Point3& a, const Point3& b) {
    const bool there = band.ContainsSegment(band.ToGrid(a), band.ToGrid(b));
    EXPECT_EQ(there, band.ContainsSegment(band.ToGrid(b), band.ToGrid(a)));
    return there;
  };
  EXPECT_TRUE(has({ 0.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }));
  EXPECT_TRUE(has({ 0.0, 0.0, 0.0 }, { 2.0, 0.1, 0.1 }));
  EXPECT_FALSE(has({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.9 }));
  EXPECT_FALSE(has({ 0.0, 0.0, 0.0 }, { 2.0, 0.0, 0.9 }));
}

TEST(VoxelBand, RefusesTooMuch)
{
  VoxelBand band;
  EXPECT_FALSE(band.Build({ { 0, 0, 0 }, { 1, 0, 0 } }, { 0.1, 0.1 }, 1e-8, 0, {}).IsOk());
  const Balls balls = RandomBalls(1000, 1.0, 0.1, 0.2);
  const dgg::Status status = band.Build(balls.Centres, balls.Radii, 0.01, 10000, {});
  EXPECT_FALSE(status.IsOk());
  EXPECT_NE(status.GetMessage().find("9.766 KiB"), std::string::npos) << status.GetMessage();
  EXPECT_NE(status.GetMessage().find("MemoryLimit"), std::string::npos) << status.GetMessage();
  EXPECT_TRUE(band.Build({}, {}, 0.1, 0, {}).IsOk());
  EXPECT_FALSE(band.Contains({ { 0, 0, 0 } }));
}

TEST(VoxelBand, RefusesTooMuchBeforeItIsTaken)
{
  // A single ball of 1e8 bricks.
  VoxelBand band;
  const dgg::Status status = band.Build({ { 0, 0, 0 } }, { 1.0 }, 1.0 / 2300.0, 100000, {});
  EXPECT_FALSE(status.IsOk());
  EXPECT_EQ(band.GetNumberOfBricks(), 0U);
  EXPECT_EQ(band.GetMemorySize(), 0U);
  EXPECT_EQ(band.GetResolution(), 0);
}

TEST(VoxelBand, RefusesTooMuchSoon)
{
  // Balls of 2e9 bricks in all, which take minutes to look at one by one.
  const Balls balls = RandomBalls(500, 1.0, 0.1, 0.2);
  VoxelBand band;
  int told = 0;
  const dgg::Status status =
    band.Build(balls.Centres, balls.Radii, 1e-4, std::size_t{ 1 } << 36, {}, [&](double done) {
      EXPECT_LE(done, 0.05);
      return ++told < 100;
    });
  EXPECT_FALSE(status.IsOk());
  EXPECT_FALSE(status.IsAborted());
  EXPECT_NE(status.GetMessage().find("64 GiB"), std::string::npos) << status.GetMessage();
}

TEST(VoxelBand, ReachesAsFarAsItSays)
{
  // At both ends of the longest axis there is, bricks are told apart.
  const double far = VoxelBand::MaximumResolution - 12.0;
  const std::vector<Point3> centres{ { 0.0, 0.0, 0.0 }, { far, 0.0, 0.0 }, { 0.0, far, far } };
  VoxelBand band;
  ASSERT_TRUE(band.Build(centres, { 3.0, 3.0, 3.0 }, 1.0, 0, {}).IsOk());
  EXPECT_LE(band.GetResolution(), VoxelBand::MaximumResolution);
  VoxelBand one;
  ASSERT_TRUE(one.Build({ centres[0] }, { 3.0 }, 1.0, 0, {}).IsOk());
  EXPECT_EQ(band.GetNumberOfVoxels(), 3 * one.GetNumberOfVoxels());
  for (const Point3& centre : centres)
  {
    for (int i = -10; i <= 10; ++i)
    {
      for (const Point3& axis : { Point3{ 1, 0, 0 }, Point3{ 0, 1, 0 }, Point3{ 0, 0, 1 } })
      {
        const Point3 p = band.ToGrid(centre + (i + 0.5) * axis);
        EXPECT_EQ(band.IsInBox(p) && band.Contains(VoxelBand::VoxelOf(p)), std::abs(i + 0.5) < 3.1);
      }
    }
  }
  EXPECT_FALSE(band.Build({ { 0, 0, 0 }, { far + 20.0, 0, 0 } }, { 3.0, 3.0 }, 1.0, 0, {}).IsOk());
}

TEST(VoxelBand, TellsOfProgressAndStops)
{
  const Balls balls = RandomBalls(30, 1.0, 0.8, 1.0);
  std::vector<double> told;
  VoxelBand band;
  ASSERT_TRUE(band
                .Build(balls.Centres, balls.Radii, 0.015, 0, {},
                  [&](double done) {
                    told.push_back(done);
                    return true;
                  })
                .IsOk());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.front(), 0.0);
  EXPECT_LE(told.back(), 1.0);
  EXPECT_GT(std::count_if(told.begin(), told.end(), [](double d) { return d < 0.5; }), 1);
  EXPECT_GT(std::count_if(told.begin(), told.end(), [](double d) { return d >= 0.5; }), 1);
  for (const std::size_t calls : { std::size_t{ 1 }, told.size() / 2, told.size() })
  {
    std::size_t called = 0;
    const dgg::Status status = band.Build(
      balls.Centres, balls.Radii, 0.015, 0, {}, [&](double) { return ++called < calls; });
    EXPECT_TRUE(status.IsAborted());
    EXPECT_EQ(called, calls);
    EXPECT_EQ(band.GetNumberOfBricks(), 0U);
    EXPECT_FALSE(band.Contains({ { 100, 100, 100 } }));
  }
}

TEST(VoxelBand, MemoryIsAsPredicted)
{
  const Balls balls = RandomBalls(3000, 1.0, 0.02, 0.05);
  VoxelBand band;
  ASSERT_TRUE(band.Build(balls.Centres, balls.Radii, 0.01, 0, {}).IsOk());
  EXPECT_LE(static_cast<double>(band.GetMemorySize()),
    1.2 * VoxelBand::PredictMemory(static_cast<double>(band.GetNumberOfBricks())));
}
