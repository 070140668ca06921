// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How long the surface is between two points of which the normals are known.
#ifndef dggArcLength_h
#define dggArcLength_h

#include "dggPoint3.h" // for Point3
#include "dggTypes.h"  // for Pi

#include <algorithm> // for std::max
#include <cmath>     // for std::sin

namespace dgg
{
/// The largest turn, in radians, of a curve that is taken for an arc: beyond it the surface is
/// sharp or the normals are noise, and nothing is known of the way in between.
constexpr double LargestTurn = Pi / 3.0;

/// How a chord leaves the surface at its ends: angles between it and the tangent planes, in
/// radians, both positive on a surface that bends away to the same side all the way.
struct ChordAngles
{
  double First = 0.0;
  double Second = 0.0;
  bool IsTurnTooLarge() const
  {
    return std::abs(this->First) + std::abs(this->Second) > LargestTurn;
  }
};

/// Normals are of length 1, or 0 where unknown; which side they point to does not matter.
inline ChordAngles MeasureChord(
  const Point3& chord, double length, const Point3& firstNormal, const Point3& secondNormal)
{
  const double sign = Dot(firstNormal, secondNormal) < 0.0 ? -1.0 : 1.0;
  const double scale = length > 0.0 ? 1.0 / length : 0.0;
  const double a = scale * Dot(firstNormal, chord);
  const double b = scale * sign * Dot(secondNormal, chord);
  return { std::asin(std::clamp(-a, -1.0, 1.0)), std::asin(std::clamp(b, -1.0, 1.0)) };
}

/// Length of the arc over a chord, by chord. A curve whose curvature changes linearly and that
/// makes small angles a and b with its chord is longer by (2 a^2 + a b + 2 b^2) / 30: that of a
/// circle when a = b, an S when a = -b. The turn of the circle that is as long is put into its
/// closed form. `variance` is that of the noise of a - b, in radians squared: noise makes curves
/// seem longer by its square, which is taken off. At least 1.
inline double ArcFactor(const ChordAngles& angles, double variance = 0.0)
{
  if (angles.IsTurnTooLarge())
  {
    return 1.0;
  }
  const double change = angles.First - angles.Second;
  // (2 a^2 + a b + 2 b^2) / 5 is a b + 2/5 (a - b)^2, and a b has no bias.
  const double square =
    angles.First * angles.Second + 0.4 * std::max(0.0, change * change - variance);
  if (!(square > 0.0))
  {
    return 1.0;
  }
  const double half = std::sqrt(square);
  // The series is exact to rounding where the quotient would lose digits.
  return half < 1e-3 ? 1.0 + square / 6.0 : half / std::sin(half);
}
}

#endif
