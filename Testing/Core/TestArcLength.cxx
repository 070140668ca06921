// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggArcLength.h"
#include "dggTypes.h"

#include <gtest/gtest.h>

#include <cmath>

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
    // Normals to either side.
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
    // All but a hundredth of what the chord lacks.
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
