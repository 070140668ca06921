// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Local surface around a cloud point, fitted to its neighbors.
#ifndef dggLocalFit_h
#define dggLocalFit_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPoint3.h"     // for Point3

#include <cstddef> // for std::size_t

namespace dgg
{
/// A quadratic height field over the fitted plane of the neighbors.
struct LocalFit
{
  /// Unit normal with arbitrary sign; 0 if no plane is defined (too few or collinear neighbors).
  Point3 Normal;
  /// Vector from the point to the fitted surface, along the normal of the plane.
  Point3 ToSurface;
  /// Largest absolute normal curvature.
  double Curvature = 0.0;
  /// Root mean square distance of the neighbors from the fitted surface, corrected for the degrees
  /// of freedom.
  double Residual = 0.0;
};

/// Returns a surface fitted to `count` neighbors of a point, including the point itself. Near
/// neighbors have more weight.
DGG_CORE_EXPORT LocalFit FitSurface(
  const Point3& point, const Point3* neighbors, std::size_t count);
}

#endif
