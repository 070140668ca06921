// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How long the surface is between two points of which the normals are known.
#ifndef dggArcLength_h
#define dggArcLength_h

#include "dggPoint3.h" // for Point3

#include <algorithm> // for std::clamp
#include <cmath>     // for std::asin

namespace dgg
{
/// How a chord leaves the surface at its ends: angles between it and the tangent planes, in
/// radians, both of the same sign on a surface that bends away to one side all the way.
struct ChordAngles
{
  double First = 0.0;
  double Second = 0.0;
  /// How much the surface turns along the chord, or more.
  double GetTurn() const { return std::abs(this->First) + std::abs(this->Second); }
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

/// Length of the arc over a chord, by chord; at least 1. A curve whose curvature changes linearly
/// and that makes small angles a and b with its chord is longer by (2 a^2 + a b + 2 b^2) / 30: that
/// of a circle when a = b, of an S when a = -b. The turn of the circle that is longer by as much is
/// put into its closed form.
inline double ArcFactor(const ChordAngles& angles)
{
  const double a = angles.First;
  const double b = angles.Second;
  const double square = std::min(1.0, (2.0 * a * a + a * b + 2.0 * b * b) / 5.0);
  const double half = std::sqrt(square);
  // Where the quotient would lose digits, the series is exact to rounding.
  return half < 1e-3 ? 1.0 + square / 6.0 : half / std::sin(half);
}

/// Height of that curve over its chord, by chord, at `t` in [0, 1].
inline double ArcHeight(const ChordAngles& angles, double t)
{
  const double rest = 1.0 - t;
  return t * rest * (angles.First * rest + angles.Second * t);
}
}

#endif
