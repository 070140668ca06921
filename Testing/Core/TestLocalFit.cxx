// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLocalFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{
using dgg::FitSurface;
using dgg::LocalFit;
using dgg::Point3;

/// Random points of the height field z = a x^2 + b y^2 around the origin, rotated, with noise.
std::vector<Point3> Samples(
  int count, double radius, double a, double b, double noise, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(-radius, radius);
  std::normal_distribution<double> error;
  std::vector<Point3> points;
  while (static_cast<int>(points.size()) < count)
  {
    const double x = place(generator);
    const double y = place(generator);
    if (x * x + y * y <= radius * radius)
    {
      const double z = a * x * x + b * y * y + noise * error(generator);
      // The z axis becomes (0, 0.6, 0.8).
      points.push_back({ x, 0.8 * y + 0.6 * z, -0.6 * y + 0.8 * z });
    }
  }
  return points;
}
}

TEST(LocalFit, QuadricsAreFound)
{
  const std::vector<Point3> points = Samples(32, 0.1, 1.5, -0.5, 0.0, 3);
  const LocalFit fit = FitSurface({ 0.0, 0.0, 0.0 }, points.data(), points.size());
  EXPECT_NEAR(std::abs(dgg::Dot(fit.Normal, { 0.0, 0.6, 0.8 })), 1.0, 1e-5);
  EXPECT_NEAR(fit.Curvature, 3.0, 0.1);
  EXPECT_LT(fit.Residual, 1e-4);
  EXPECT_LT(dgg::Norm(fit.ToSurface), 1e-4);
}

TEST(LocalFit, NoiseIsMeasuredAndPointsAreMovedToTheSurface)
{
  const double noise = 0.004;
  double residual = 0.0;
  double off = 0.0;
  const int trials = 50;
  for (int trial = 0; trial < trials; ++trial)
  {
    std::vector<Point3> points = Samples(60, 0.1, 0.8, 0.8, noise, 100 + trial);
    // Three times the noise off the surface.
    const Point3 point{ 0.0, 0.6 * 3.0 * noise, 0.8 * 3.0 * noise };
    points.push_back(point);
    const LocalFit fit = FitSurface(point, points.data(), points.size());
    residual += fit.Residual / trials;
    off += dgg::Norm(point + fit.ToSurface) / trials;
  }
  EXPECT_NEAR(residual, noise, 0.25 * noise);
  EXPECT_LT(off, noise);
}

TEST(LocalFit, TooLittleForAPlane)
{
  const Point3 origin;
  const std::vector<Point3> line{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } };
  EXPECT_EQ(dgg::Norm(FitSurface(origin, line.data(), line.size()).Normal), 0.0);
  EXPECT_EQ(dgg::Norm(FitSurface(origin, line.data(), 2).Normal), 0.0);
  const std::vector<Point3> same(20, Point3{ 1.0, 2.0, 3.0 });
  EXPECT_EQ(dgg::Norm(FitSurface(same[0], same.data(), same.size()).Normal), 0.0);
  // A plane only.
  const std::vector<Point3> square{ { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const LocalFit fit = FitSurface({ 0.5, 0.5, 0.0 }, square.data(), square.size());
  EXPECT_NEAR(std::abs(fit.Normal.Z), 1.0, 1e-12);
  EXPECT_NEAR(fit.ToSurface.Z, 1.0, 1e-12);
  EXPECT_EQ(fit.Curvature, 0.0);
}

TEST(LocalFit, NeighboursOnACircleDoNotDecideOnAQuadric)
{
  std::vector<Point3> ring;
  for (int i = 0; i < 12; ++i)
  {
    ring.push_back({ std::cos(i * 0.5236), std::sin(i * 0.5236), 0.0 });
  }
  const LocalFit fit = FitSurface({ 0.0, 0.0, 0.0 }, ring.data(), ring.size());
  EXPECT_NEAR(std::abs(fit.Normal.Z), 1.0, 1e-6);
  EXPECT_LT(fit.Curvature, 1e-3);
}
