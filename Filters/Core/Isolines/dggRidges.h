// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Ridges of distances on a surface.
#ifndef dggRidges_h
#define dggRidges_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggDistanceField.h" // for DistanceField
#include "dggParallel.h"      // for ParallelFor
#include "dggSurfacePath.h"   // for SurfacePath

#include <vector> // for the lines

namespace dgg
{
struct RidgeOptions
{
  /// Minimum angle between the directions to the source on both sides of a ridge, radians. On a
  /// polyhedron, a ridge of small angle starts at every convex vertex, and would clutter the
  /// result. Values below a tenth of a degree are raised to a tenth of a degree. With virtual
  /// sources, values below ten degrees are raised to ten degrees, because smaller angles are
  /// transitions between models.
  double MinimumAngle = 20.0 * Pi / 180.0;
  /// Largest distance of a line from the ridge, model units, at least 0; 0 means a thousandth of
  /// the mean edge length.
  double ChordTolerance = 0.0;
  /// If true, find the lines between points with different nearest sources instead, at any angle.
  /// Needs windows and DistanceField::NearestSource. Lines along edges are not found.
  bool BetweenSources = false;
};

/// Polylines on a surface that meet only at their ends.
struct Ridges
{
  std::vector<SurfacePath> Lines;
  std::vector<double> Angles; ///< per line, the mean angle between the two directions, radians
  /// Number of pieces within a face that may exceed the tolerance, for example where the field is
  /// discontinuous.
  Id Fallbacks = 0;
};

/// Finds the ridges (the cut locus) of a distance: the points with at least two shortest paths.
/// Ridges meet in points with three shortest paths, and end at convex vertices and at points where
/// the angle falls below the minimum; mesh vertices on a ridge are points of the lines. Inside
/// faces, and where a ridge crosses an edge, the two distances of a point are equal up to rounding
/// (Mitchell, Mount and Papadimitriou, "The discrete geodesic problem", 1987).
///
/// The field must have windows or virtual sources: values at vertices do not determine ridges. With
/// virtual sources, only ridges of large angles are found, with gaps.
///
/// The result does not depend on `parallel`. After a failure, `ridges` must not be used.
DGG_CORE_EXPORT Status FindRidges(const DistanceField& field, const RidgeOptions& options,
  const ParallelFor& parallel, const ProgressCallback& progress, Ridges& ridges);
}

#endif
