// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the points of a cloud are, and how large it is. Internal.
#ifndef dggCloudFrame_h
#define dggCloudFrame_h

#include "dggInvalidInput.h" // for InvalidInput
#include "dggPoint3.h"       // for Point3
#include "dggTypes.h"        // for Id, Status

#include <algorithm> // for std::min
#include <cmath>     // for std::frexp
#include <cstddef>   // for std::size_t

namespace dgg
{
/// One of `points`, x y z each.
inline Point3 PointAt(const double* points, Id i)
{
  const double* p = points + 3 * static_cast<std::size_t>(i);
  return { p[0], p[1], p[2] };
}

/// The box around the finite points of a cloud. Local coordinates start in its middle and are
/// scaled by a power of two, so that no digit is lost by that: into [-1, 1].
class CloudFrame
{
public:
  CloudFrame() = default;
  /// `points` are x y z per point. Those of which `isLeftOut` is true, of finite ones, do not
  /// count.
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
      // Halves first: the extent of large numbers may be beyond the range of double.
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

  /// Of those that are finite, and not left out.
  Id GetNumberOfPoints() const { return this->NumberOfPoints; }
  /// Fails when squares of lengths, and what the arithmetic of lengths needs besides, are not in
  /// the range of double.
  Status CheckRange() const
  {
    const double half = this->GetHalfExtent();
    if (half == 0.0 || (half >= 1e-150 && half <= 1e150))
    {
      return Status::Success();
    }
    return InvalidInput("the points are spread over ", half,
      " units to each side, out of the range of the arithmetic: scale them");
  }
  /// Half of the longest side of the box.
  double GetHalfExtent() const { return std::max({ this->Half.X, this->Half.Y, this->Half.Z }); }
  double GetDiagonal() const { return 2.0 * std::hypot(this->Half.X, this->Half.Y, this->Half.Z); }
  /// From units of the points to local ones.
  double GetScale() const { return this->Scale; }
  Point3 ToLocal(const Point3& point) const { return this->Scale * (point - this->Middle); }

private:
  Id NumberOfPoints = 0;
  Point3 Middle;
  Point3 Half; ///< sides of the box
  double Scale = 1.0;
};
}

#endif
