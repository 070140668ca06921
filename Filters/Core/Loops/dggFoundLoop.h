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
  /// Angles that are smaller than pi by at most this tolerance count as straight: the possible gain
  /// of a shorter loop is of second order.
  static constexpr double KinkTolerance = 1e-5;

  /// The closed path: the last point equals the first. Empty if there is no loop.
  SurfacePath Loop;
  /// The smaller of the two angles of the loop at a required point, radians, at most pi; the
  /// minimum over all required points. Less than pi if the loop has a kink there, pi for a closed
  /// geodesic.
  double Angle = Pi;

  bool IsKinked() const { return this->Angle < Pi - KinkTolerance; }
};
}

#endif
