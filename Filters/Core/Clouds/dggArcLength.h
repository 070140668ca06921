// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Arc length of the surface between two points with known normals.
#ifndef dggArcLength_h
#define dggArcLength_h

#include "dggPoint3.h" // for Point3

#include <algorithm> // for std::clamp
#include <cmath>     // for std::asin

namespace dgg
{
/// Angles between a chord and the tangent planes at its ends, in radians; both have the same sign
/// on a surface that curves to one side along the entire chord.
struct ChordAngles
{
  double First = 0.0;
  double Second = 0.0;
  /// Returns an upper bound of the total turning of the surface along the chord, in radians.
  double GetTurn() const { return std::abs(this->First) + std::abs(this->Second); }
};

/// Returns the chord angles. Normals are of length 1, or 0 if unknown; their orientation is
/// irrelevant.
inline ChordAngles MeasureChord(
  const Point3& chord, double length, const Point3& firstNormal, const Point3& secondNormal)
{
  const double sign = Dot(firstNormal, secondNormal) < 0.0 ? -1.0 : 1.0;
  const double scale = length > 0.0 ? 1.0 / length : 0.0;
  const double a = scale * Dot(firstNormal, chord);
  const double b = scale * sign * Dot(secondNormal, chord);
  return { std::asin(std::clamp(-a, -1.0, 1.0)), std::asin(std::clamp(b, -1.0, 1.0)) };
}

/// Returns the ratio of arc length to chord length, at least 1. A curve whose curvature changes
/// linearly and whose angles with its chord are a and b, both small, is longer by (2 a^2 + a b + 2
/// b^2) / 30. For a = b this is the excess of a circle, for a = -b the excess of an S-curve. The
/// closed form of a circular arc is evaluated for the turning angle that gives the same excess.
inline double ArcFactor(const ChordAngles& angles)
{
  const double a = angles.First;
  const double b = angles.Second;
  const double square = (std::min)(1.0, (2.0 * a * a + a * b + 2.0 * b * b) / 5.0);
  const double half = std::sqrt(square);
  // For small angles the quotient would lose digits, and the series is exact up to rounding.
  return half < 1e-3 ? 1.0 + square / 6.0 : half / std::sin(half);
}

/// Returns the height of the curve of ArcFactor() over its chord at `t` in [0, 1], relative to the
/// chord length.
inline double ArcHeight(const ChordAngles& angles, double t)
{
  const double rest = 1.0 - t;
  return t * rest * (angles.First * rest + angles.Second * t);
}
}

#endif
