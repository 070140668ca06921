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
  /// Ridges are shown where the directions to the source differ by more than this angle, radians.
  /// On a polyhedron a ridge of small angle starts at each convex vertex, which hides the others.
  /// Angles below a tenth of a degree count as that; with virtual sources, angles below ten
  /// degrees, where these show how one model gives way to the next.
  double MinimumAngle = 20.0 * Pi / 180.0;
  /// How far a line may be from the ridge, a length; 0 means a thousandth of the mean edge
  /// length.
  double ChordTolerance = 0.0;
};

/// Polylines on a surface. They meet at their ends alone.
struct Ridges
{
  std::vector<SurfacePath> Lines;
  std::vector<double> Angles; ///< per line, the mean angle between the two directions, radians
  /// Pieces within one face that may be farther from the ridge than the tolerance, as where the
  /// field is not continuous.
  Id Fallbacks = 0;
};

/// Find the ridges (the cut locus) of a distance: the points with two shortest paths or more. They
/// meet in points with three, and end at convex vertices and where the angle falls below the
/// minimum; vertices of the mesh that they pass are points of the lines. The two distances of a
/// point are equal up to rounding inside of faces and where a ridge crosses an edge (Mitchell,
/// Mount and Papadimitriou, "The discrete geodesic problem", 1987).
///
/// The field must have windows or virtual sources: values at vertices do not show ridges. Virtual
/// sources show those of large angles, with gaps.
///
/// The result does not depend on `parallel`.
DGG_CORE_EXPORT Status FindRidges(const DistanceField& field, const RidgeOptions& options,
  const ParallelFor& parallel, const ProgressCallback& progress, Ridges& ridges);
}

#endif
