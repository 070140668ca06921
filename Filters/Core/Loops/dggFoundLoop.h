// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A closed path and how smooth it is.
#ifndef dggFoundLoop_h
#define dggFoundLoop_h

#include "dggSurfacePath.h" // for SurfacePath

namespace dgg
{
struct FoundLoop
{
  /// Angles smaller than pi by no more than this count as straight: what a shorter loop could gain
  /// there is the square.
  static constexpr double KinkTolerance = 1e-5;

  /// Closed: the last point is the first one again. Empty when there is no loop.
  SurfacePath Loop;
  /// The smaller angle of the loop, radians, pi at most, at the points that it was asked to go
  /// through, the smallest when there are several: less than pi when it has a kink there, pi when
  /// it is a closed geodesic.
  double Angle = Pi;

  bool IsKinked() const { return this->Angle < Pi - KinkTolerance; }
};
}

#endif
