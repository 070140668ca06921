// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSegmentWalk.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

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

/// How much of a segment lies in a cell that is larger by `margin` on each side.
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
  // Exactly through corners: one step along one axis at a time, and no step too many.
  const std::vector<Cell> diagonal = CellsOf({ 0.0, 0.0, 0.0 }, { 4.0, 4.0, 4.0 });
  EXPECT_EQ(diagonal.size(), 13U);
  EXPECT_EQ(diagonal.back(), (Cell{ { 4, 4, 4 } }));
  const std::vector<Cell> back = CellsOf({ 4.0, 4.0, 4.0 }, { 0.0, 0.0, 0.0 });
  EXPECT_EQ(back.back(), (Cell{ { 0, 0, 0 } }));
}

TEST(SegmentWalk, StopsWhenTold)
{
  int visits = 0;
  EXPECT_FALSE(dgg::WalkSegment({ 0.5, 0.5, 0.5 }, { 9.5, 0.5, 0.5 },
    [&](std::int32_t x, std::int32_t, std::int32_t) { return ++visits, x < 3; }));
  EXPECT_EQ(visits, 4);
}
