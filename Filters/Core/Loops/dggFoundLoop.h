// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A closed path with its kink angle.
#ifndef dggFoundLoop_h
#define dggFoundLoop_h

#include "dggSurfacePath.h" // for SurfacePath

namespace dgg
{
struct FoundLoop
{
  /// Kink tolerance, radians. Angles that are smaller than pi by at most this tolerance count as
  /// straight, because the possible gain of a shorter loop is of second order.
  static constexpr double KinkTolerance = 1e-5;

  /// Closed path: the last point equals the first. Empty if no loop exists.
  SurfacePath Loop;
  /// Minimum over all required points of the smaller of the two angles of the loop at the point,
  /// radians, at most pi. Less than pi if the loop has a kink at a required point, pi for a closed
  /// geodesic.
  double Angle = Pi;

  bool IsKinked() const { return this->Angle < Pi - KinkTolerance; }
};
}

#endif
