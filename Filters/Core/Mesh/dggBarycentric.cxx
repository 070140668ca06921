// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBarycentric.h"

#include "dggTypes.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Largest deviation of a sum of coordinates from 1, and largest amount of a coordinate below 0.
constexpr double CoordinateTolerance = 1e-6;

using Vector = std::array<double, 3>;
}

bool AreBarycentric(const std::array<double, 3>& b)
{
  const bool isPositive =
    b[0] >= -CoordinateTolerance && b[1] >= -CoordinateTolerance && b[2] >= -CoordinateTolerance;
  return isPositive && std::abs(b[0] + b[1] + b[2] - 1.0) <= CoordinateTolerance; // false for NaN
}

std::array<double, 3> FindClosestInTriangle(
  const TriangleCorners& corners, const std::array<double, 3>& position, double& squaredDistance)
{
  Vector best{ { 1.0, 0.0, 0.0 } };
  squaredDistance = Infinity;
  const Vector ab = corners[1] - corners[0];
  const Vector ac = corners[2] - corners[0];
  const Vector ap = position - corners[0];
  auto offer = [&](const Vector& weights) {
    Vector offset;
    for (int i = 0; i < 3; ++i)
    {
      offset[i] = ap[i] - weights[1] * ab[i] - weights[2] * ac[i];
    }
    const double square = Dot(offset, offset);
    if (square < squaredDistance)
    {
      squaredDistance = square;
      best = weights;
    }
  };
  for (int k = 0; k < 3; ++k) // edges come first, so that a tie is on the edge
  {
    const int next = (k + 1) % 3;
    const Vector edge = corners[next] - corners[k];
    const double square = Dot(edge, edge);
    const double along = square > 0.0 ? Dot(position - corners[k], edge) / square : 0.0;
    Vector weights{ { 0.0, 0.0, 0.0 } };
    weights[next] = std::min(1.0, std::max(0.0, along));
    weights[k] = 1.0 - weights[next];
    offer(weights);
  }
  const Vector normal = Cross(ab, ac);
  const double square = Dot(normal, normal);
  if (square > 0.0)
  {
    const double v = Dot(Cross(ap, ac), normal) / square;
    const double w = Dot(Cross(ab, ap), normal) / square;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0)
    {
      offer({ { 1.0 - v - w, v, w } });
    }
  }
  return best;
}

bool ConvertToPart(const TriangleCorners& corners, const std::array<double, 3>& coordinates,
  std::array<double, 3>& inPart)
{
  const double area = Dot(corners[0], Cross(corners[1], corners[2]));
  if (area == 0.0)
  {
    return false;
  }
  for (int k = 0; k < 3; ++k)
  {
    inPart[k] = Dot(coordinates, Cross(corners[(k + 1) % 3], corners[(k + 2) % 3])) / area;
  }
  return true;
}

std::array<double, 3> ConvertFromPart(
  const TriangleCorners& corners, const std::array<double, 3>& inPart)
{
  Vector result{ { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    for (int i = 0; i < 3; ++i)
    {
      result[i] += inPart[k] * corners[k][i];
    }
  }
  return result;
}
}
