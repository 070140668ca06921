// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GraphChecks.h"

#include "dggArcLength.h"
#include "dggSegmentWalk.h"
#include "dggTypes.h"
#include "dggVoxelBand.h"

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

TEST(VoxelBand, SmallBallsMarkTheirVoxelAndItsNeighbors)
{
  VoxelBand band;
  ASSERT_TRUE(band.Build({ { 0.5, 0.5, 0.5 } }, { 0.01 }, 1.0, 0, {}).IsOk());
  EXPECT_EQ(band.GetNumberOfVoxels(), 7U);
  ASSERT_TRUE(band.Build({ { 0.5, 0.5, 0.5 } }, { 0.0 }, 1.0, 0, {}).IsOk());
  EXPECT_EQ(band.GetNumberOfVoxels(), 7U);
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

TEST(VoxelBand, ReachesAsFarAsItSays)
{
  // At both ends of the longest possible axis, bricks are separate.
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

TEST(VoxelBand, MemoryIsAsPredicted)
{
  const Balls balls = RandomBalls(3000, 1.0, 0.02, 0.05);
  VoxelBand band;
  ASSERT_TRUE(band.Build(balls.Centres, balls.Radii, 0.01, 0, {}).IsOk());
  EXPECT_LE(static_cast<double>(band.GetMemorySize()),
    1.2 * VoxelBand::PredictMemory(static_cast<double>(band.GetNumberOfBricks())));
}

namespace
{
using dgg::Point3;
using Cell = std::array<std::int32_t, 3>;

std::vector<Cell> CellsOf(const Point3& from, const Point3& to)
{
  std::vector<Cell> cells;
  dgg::WalkSegment(from, to, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    cells.push_back({ { x, y, z } });
    return true;
  });
  return cells;
}

/// Returns the fraction of a segment inside a cell enlarged by `margin` on each side; negative if
/// the segment misses the cell.
double PartIn(const Cell& cell, const Point3& from, const Point3& to, double margin)
{
  const std::array<double, 3> start{ { from.X, from.Y, from.Z } };
  const std::array<double, 3> end{ { to.X, to.Y, to.Z } };
  double first = 0.0;
  double last = 1.0;
  for (int k = 0; k < 3; ++k)
  {
    const double low = cell[k] - margin - start[k];
    const double high = cell[k] + 1 + margin - start[k];
    const double d = end[k] - start[k];
    if (d == 0.0)
    {
      if (low > 0.0 || high < 0.0)
      {
        return -1.0;
      }
      continue;
    }
    first = std::max(first, std::min(low / d, high / d));
    last = std::min(last, std::max(low / d, high / d));
  }
  return last - first;
}
}

TEST(SegmentWalk, VisitsWhatTheSegmentGoesThrough)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> coordinate(-12.0, 12.0);
  for (int trial = 0; trial < 500; ++trial)
  {
    const Point3 from{ coordinate(generator), coordinate(generator), coordinate(generator) };
    const Point3 to{ coordinate(generator), coordinate(generator), coordinate(generator) };
    const std::vector<Cell> cells = CellsOf(from, to);
    double covered = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      EXPECT_GE(PartIn(cells[i], from, to, 1e-9), 0.0);
      covered += std::max(0.0, PartIn(cells[i], from, to, 0.0));
      if (i > 0)
      {
        int steps = 0;
        for (int k = 0; k < 3; ++k)
        {
          steps += std::abs(cells[i][k] - cells[i - 1][k]);
        }
        EXPECT_EQ(steps, 1);
      }
    }
    EXPECT_NEAR(covered, 1.0, 1e-9);
    EXPECT_EQ(cells.back()[0], static_cast<std::int32_t>(std::floor(to.X)));
    EXPECT_EQ(cells.back()[1], static_cast<std::int32_t>(std::floor(to.Y)));
    EXPECT_EQ(cells.back()[2], static_cast<std::int32_t>(std::floor(to.Z)));
  }
}

TEST(SegmentWalk, AlongAxesAndThroughCorners)
{
  EXPECT_EQ(CellsOf({ 0.5, 0.5, 0.5 }, { 3.5, 0.5, 0.5 }).size(), 4U);
  EXPECT_EQ(CellsOf({ 0.5, 0.5, 0.5 }, { 0.5, -2.5, 0.5 }).size(), 4U);
  EXPECT_EQ(CellsOf({ 0.5, 0.5, 0.5 }, { 0.5, 0.5, 0.5 }).size(), 1U);
  // A segment exactly through corners takes one step along one axis at a time, without superfluous
  // steps.
  const std::vector<Cell> diagonal = CellsOf({ 0.0, 0.0, 0.0 }, { 4.0, 4.0, 4.0 });
  EXPECT_EQ(diagonal.size(), 13U);
  EXPECT_EQ(diagonal.back(), (Cell{ { 4, 4, 4 } }));
  const std::vector<Cell> back = CellsOf({ 4.0, 4.0, 4.0 }, { 0.0, 0.0, 0.0 });
  EXPECT_EQ(back.back(), (Cell{ { 0, 0, 0 } }));
}

namespace
{
using dgg::ArcFactor;
using dgg::ChordAngles;
using dgg::MeasureChord;
using dgg::Point3;
}

TEST(ArcLength, CirclesAreExact)
{
  for (const double turn : { 1e-6, 1e-3, 0.1, 0.5, 1.0 })
  {
    const Point3 first{ 1.0, 0.0, 0.0 };
    const Point3 second{ std::cos(turn), std::sin(turn), 0.0 };
    const Point3 chord = second - first;
    const double length = dgg::Norm(chord);
    // Normals on either side.
    for (const double side : { 1.0, -1.0 })
    {
      const ChordAngles angles = MeasureChord(chord, length, first, side * second);
      EXPECT_NEAR(angles.GetTurn(), turn, 1e-9);
      EXPECT_NEAR(length * ArcFactor(angles) / turn, 1.0, 1e-9) << turn;
      EXPECT_NEAR(dgg::ArcHeight(angles, 0.5) * length, 1.0 - std::cos(0.5 * turn),
        0.05 * turn * turn * turn * turn + 1e-9);
    }
  }
}

TEST(ArcLength, ChangingCurvatureAndInflections)
{
  // y = k x^3 / 6 + c x^2 / 2: the curvature changes linearly for small slopes.
  for (const double c : { 0.0, 0.2, -0.3 })
  {
    const double k = 0.3;
    const double h = 0.3;
    const auto y = [&](double x) { return k * x * x * x / 6.0 + c * x * x / 2.0; };
    const auto slope = [&](double x) { return k * x * x / 2.0 + c * x; };
    const Point3 from{ -h, y(-h), 0.0 };
    const Point3 to{ h, y(h), 0.0 };
    const auto normal = [&](double x) {
      const double scale = 1.0 / std::hypot(1.0, slope(x));
      return Point3{ -scale * slope(x), scale, 0.0 };
    };
    double length = 0.0;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i)
    {
      const double a = -h + 2.0 * h * i / steps;
      const double b = -h + 2.0 * h * (i + 1) / steps;
      length += std::hypot(b - a, y(b) - y(a));
    }
    const double chord = dgg::Norm(to - from);
    const double found = chord * ArcFactor(MeasureChord(to - from, chord, normal(-h), normal(h)));
    EXPECT_GT(length, chord);
    // At most one hundredth of the difference between length and chord remains.
    EXPECT_NEAR(found, length, 0.01 * (length - chord)) << c;
  }
}

TEST(ArcLength, WithoutNormalsAChordIsAChord)
{
  const Point3 none;
  const ChordAngles angles = MeasureChord({ 1.0, 2.0, 2.0 }, 3.0, none, none);
  EXPECT_EQ(ArcFactor(angles), 1.0);
  EXPECT_EQ(ArcFactor(MeasureChord(none, 0.0, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 })), 1.0);
}
