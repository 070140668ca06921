// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBandPath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{
using dgg::BandPath;
using dgg::BandPathShortener;
using dgg::Id;
using dgg::Offset;
using dgg::Point3;

/// A cloud and its graph of all pairs within a given reach.
struct NearGraph
{
  NearGraph(std::vector<double> points, double reach, double radius)
    : Points(std::move(points))
    , Radii(this->Points.size() / 3, radius)
  {
    const Id n = static_cast<Id>(this->Radii.size());
    this->Offsets.push_back(0);
    for (Id i = 0; i < n; ++i)
    {
      for (Id j = 0; j < n; ++j)
      {
        const double d = dgg::Norm(this->At(i) - this->At(j));
        if (i != j && d <= reach)
        {
          this->Targets.push_back(j);
          this->Lengths.push_back(static_cast<float>(d));
        }
      }
      this->Offsets.push_back(static_cast<Offset>(this->Targets.size()));
    }
  }

  Point3 At(Id i) const
  {
    return { this->Points[3 * i], this->Points[3 * i + 1], this->Points[3 * i + 2] };
  }

  dgg::GraphView View() const
  {
    dgg::GraphView view;
    view.Info.Kind = dgg::GraphKind::Cloud;
    view.NumberOfVertices = static_cast<Id>(this->Radii.size());
    view.Offsets = this->Offsets.data();
    view.Targets = this->Targets.data();
    view.Lengths = this->Lengths.data();
    return view;
  }

  /// Returns a greedy path that continues to the neighbor nearest to the end.
  std::vector<Id> GreedyPath(Id from, Id to) const
  {
    std::vector<Id> path{ from };
    while (path.back() != to)
    {
      const Id v = path.back();
      Id best = v;
      for (Offset e = this->Offsets[v]; e < this->Offsets[v + 1]; ++e)
      {
        const Id t = this->Targets[e];
        best = dgg::Norm(this->At(t) - this->At(to)) < dgg::Norm(this->At(best) - this->At(to))
          ? t
          : best;
      }
      if (best == v)
      {
        return {};
      }
      path.push_back(best);
    }
    return path;
  }

  double LengthOf(const std::vector<Id>& path) const
  {
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      length += dgg::Norm(this->At(path[i]) - this->At(path[i - 1]));
    }
    return length;
  }

  std::vector<double> Points;
  std::vector<double> Radii;
  std::vector<Offset> Offsets;
  std::vector<Id> Targets;
  std::vector<float> Lengths;
};

std::vector<double> SpherePoints(int count)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> number;
  std::vector<double> points;
  for (int i = 0; i < count; ++i)
  {
    const Point3 p{ number(generator), number(generator), number(generator) };
    const double scale = 1.0 / dgg::Norm(p);
    for (const double x : { scale * p.X, scale * p.Y, scale * p.Z })
    {
      points.push_back(x);
    }
  }
  return points;
}

constexpr double Spacing = 0.0793; // mean spacing of 2000 points on a sphere
}

TEST(BandPath, GreatCircles)
{
  const NearGraph cloud(SpherePoints(2000), 3.0 * Spacing, 1.5 * Spacing);
  const dgg::GraphView view = cloud.View();
  const BandPathShortener shortener(cloud.Points.data(), view, cloud.Radii.data());
  int found = 0;
  for (Id to = 1; to < 40; ++to)
  {
    const std::vector<Id> vertices = cloud.GreedyPath(0, to);
    const double truth = std::acos(dgg::Dot(cloud.At(0), cloud.At(to)));
    if (vertices.empty() || truth < 0.5 || truth > 2.6)
    {
      continue;
    }
    ++found;
    BandPath path;
    ASSERT_TRUE(shortener.Shorten(vertices, nullptr, nullptr, path).IsOk());
    EXPECT_EQ(path.Vertices.front(), 0);
    EXPECT_EQ(path.Vertices.back(), to);
    EXPECT_EQ(path.Points.front().X, cloud.At(0).X);
    EXPECT_EQ(path.Points.back().X, cloud.At(to).X);
    EXPECT_NEAR(path.Length, truth, 0.005 * truth) << to;
    EXPECT_GT(cloud.LengthOf(vertices), 1.01 * truth);
    double sum = 0.0;
    for (std::size_t i = 0; i < path.Points.size(); ++i)
    {
      EXPECT_NEAR(dgg::Norm(path.Points[i]), 1.0, 2e-3);
      sum += i > 0 ? dgg::Norm(path.Points[i] - path.Points[i - 1]) : 0.0;
    }
    EXPECT_NEAR(sum, path.Length, 1e-12);
    EXPECT_EQ(std::count(path.Vertices.begin(), path.Vertices.end(), dgg::NoId),
      static_cast<std::ptrdiff_t>(path.Vertices.size()) - 2);
  }
  EXPECT_GT(found, 15);
}

TEST(BandPath, StaysOnItsSideOfAHole)
{
  // A plate with a hole in the middle: straightening must not draw the path through the hole.
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::vector<double> points{ -0.9, -0.02, 0.0, 0.9, -0.02, 0.0 };
  while (points.size() < 3 * 3000)
  {
    const double x = place(generator);
    const double y = place(generator);
    if (std::hypot(x, y) > 0.5)
    {
      for (const double x : { x, y, 0.0 })
      {
        points.push_back(x);
      }
    }
  }
  const double s = std::sqrt((4.0 - 0.25 * dgg::Pi) / 3000.0);
  const NearGraph cloud(points, 3.0 * s, 1.5 * s);
  const dgg::GraphView view = cloud.View();
  // The initial path follows the upper half.
  std::vector<Id> vertices{ 0 };
  for (int k = 1; k < 20; ++k)
  {
    const double angle = dgg::Pi * (1.0 - k / 20.0);
    const Point3 goal{ 0.7 * std::cos(angle), 0.7 * std::sin(angle), 0.0 };
    Id best = 0;
    for (Id i = 0; i < 3000; ++i)
    {
      best = dgg::Norm(cloud.At(i) - goal) < dgg::Norm(cloud.At(best) - goal) ? i : best;
    }
    vertices.push_back(best);
  }
  vertices.push_back(1);
  const BandPathShortener shortener(cloud.Points.data(), view, cloud.Radii.data());
  BandPath path;
  ASSERT_TRUE(shortener.Shorten(vertices, nullptr, nullptr, path).IsOk());
  EXPECT_LT(path.Length, cloud.LengthOf(vertices));
  // Tangents and an arc around the hole. The path is slightly longer because the rim of the sampled
  // hole is uneven.
  const double tangent = std::sqrt(0.81 - 0.25);
  const double arc = 0.5 * (dgg::Pi - 2.0 * std::acos(0.5 / 0.9));
  EXPECT_NEAR(path.Length, 2.0 * tangent + arc, 0.05);
  double least = 1.0;
  for (const Point3& p : path.Points)
  {
    least = std::min(least, std::hypot(p.X, p.Y));
  }
  EXPECT_GT(least, 0.5 - 0.5 * s);
}

TEST(BandPath, EndsOffTheCloudAndTrivialPaths)
{
  const NearGraph cloud(SpherePoints(500), 0.5, 0.24);
  const dgg::GraphView view = cloud.View();
  const BandPathShortener shortener(cloud.Points.data(), view, cloud.Radii.data());
  BandPath path;
  ASSERT_TRUE(shortener.Shorten({}, nullptr, nullptr, path).IsOk());
  EXPECT_TRUE(path.Points.empty());
  ASSERT_TRUE(shortener.Shorten({ 7 }, nullptr, nullptr, path).IsOk());
  ASSERT_EQ(path.Points.size(), 1U);
  EXPECT_EQ(path.Vertices[0], 7);
  EXPECT_EQ(path.Length, 0.0);
  const Point3 start = 1.01 * cloud.At(7);
  ASSERT_TRUE(shortener.Shorten({ 7 }, &start, nullptr, path).IsOk());
  EXPECT_EQ(path.Vertices.front(), dgg::NoId);
  EXPECT_EQ(path.Vertices.back(), 7);
  EXPECT_NEAR(path.Length, 0.01, 1e-6);
  const Point3 end = 1.02 * cloud.At(7);
  ASSERT_TRUE(shortener.Shorten({ 7 }, &start, &end, path).IsOk());
  EXPECT_EQ(path.Points.back().X, end.X);
  EXPECT_EQ(path.Vertices.back(), dgg::NoId);
  EXPECT_FALSE(shortener.Shorten({ 7, 500 }, nullptr, nullptr, path).IsOk());
  EXPECT_FALSE(shortener.Shorten({ -1 }, nullptr, nullptr, path).IsOk());
}
