// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Center and extent of a point cloud. Internal.
#ifndef dggCloudFrame_h
#define dggCloudFrame_h

#include "dggPoint3.h" // for Point3
#include "dggStatus.h"
#include "dggStatus.h" // for Status

#include <algorithm> // for std::min
#include <cmath>     // for std::frexp

namespace dgg
{
/// Bounding box of the finite points of a cloud. Local coordinates are relative to the center of
/// the box and scaled into [-1, 1] by a power of two, so that scaling is exact.
class CloudFrame
{
public:
  CloudFrame() = default;
  /// Computes the box of `points` (x y z each). Ignores points with a non-finite coordinate, and
  /// points for which `isLeftOut` returns true.
  template <typename Test>
  CloudFrame(const double* points, Id numberOfPoints, Test&& isLeftOut)
  {
    Point3 low{ Infinity, Infinity, Infinity };
    Point3 high{ -Infinity, -Infinity, -Infinity };
    for (Id i = 0; i < numberOfPoints; ++i)
    {
      const Point3 p = PointAt(points, i);
      if (IsFinite(p) && !isLeftOut(p))
      {
        ++this->NumberOfPoints;
        low = { std::min(low.X, p.X), std::min(low.Y, p.Y), std::min(low.Z, p.Z) };
        high = { std::max(high.X, p.X), std::max(high.Y, p.Y), std::max(high.Z, p.Z) };
      }
    }
    if (this->NumberOfPoints > 0)
    {
      // The bounds are halved first, since the extent of large numbers may exceed the range of
      // double.
      this->Middle = 0.5 * low + 0.5 * high;
      this->Half = 0.5 * high - 0.5 * low;
    }
    int exponent = 0;
    std::frexp(this->GetHalfExtent(), &exponent);
    this->Scale = this->GetHalfExtent() > 0.0 ? std::ldexp(1.0, -exponent) : 1.0;
  }
  CloudFrame(const double* points, Id numberOfPoints)
    : CloudFrame(points, numberOfPoints, [](const Point3&) { return false; })
  {
  }

  /// Returns the number of finite points that are not ignored.
  Id GetNumberOfPoints() const { return this->NumberOfPoints; }
  /// Fails if squares of lengths and intermediate results of length computations are outside the
  /// range of double.
  Status CheckRange() const
  {
    const double half = this->GetHalfExtent();
    if (half == 0.0 || (half >= 1e-150 && half <= 1e150))
    {
      return Status::Success();
    }
    return InvalidInput("The points extend over ", half,
      " units to each side, which is out of the range of floating-point numbers")
      .Fix("Scale the points");
  }
  /// Returns half the length of the longest side of the box.
  double GetHalfExtent() const { return std::max({ this->Half.X, this->Half.Y, this->Half.Z }); }
  double GetDiagonal() const { return 2.0 * std::hypot(this->Half.X, this->Half.Y, this->Half.Z); }
  /// Returns the factor from units of the points to local units.
  double GetScale() const { return this->Scale; }
  Point3 ToLocal(const Point3& point) const { return this->Scale * (point - this->Middle); }

private:
  Id NumberOfPoints = 0;
  Point3 Middle;
  Point3 Half; ///< half the side lengths of the box
  double Scale = 1.0;
};
}

#endif
