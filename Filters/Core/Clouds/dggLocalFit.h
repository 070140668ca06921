// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The surface around a point of a cloud, fitted to its neighbours.
#ifndef dggLocalFit_h
#define dggLocalFit_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPoint3.h"     // for Point3

#include <cstddef> // for std::size_t

namespace dgg
{
/// A quadratic height field over the plane of the neighbours.
struct LocalFit
{
  /// Of length 1, to either side; 0 when there is no plane: too few neighbours, or all in a line.
  Point3 Normal;
  /// From the point to the fitted surface along the normal of the plane.
  Point3 ToSurface;
  /// The largest normal curvature, without sign.
  double Curvature = 0.0;
  /// Root of the mean square of the distances of neighbours from the fitted surface, corrected for
  /// the numbers that were fitted.
  double Residual = 0.0;
};

/// Fit to `count` neighbours of a point, the point itself included. Near ones weigh more.
DGG_CORE_EXPORT LocalFit FitSurface(
  const Point3& point, const Point3* neighbors, std::size_t count);
}

#endif
