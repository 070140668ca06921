// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines of distances on a surface.
#ifndef dggIsolines_h
#define dggIsolines_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggDistanceField.h" // for DistanceField
#include "dggParallel.h"      // for ParallelFor
#include "dggSurfacePath.h"   // for SurfacePath

#include <vector> // for the lines

namespace dgg
{
/// Interpolation of the distance inside faces.
enum class IsolineMethod
{
  LocalSources, ///< as defined by DistanceField
  Apollonius    ///< as published, for comparison: dggApolloniusParts.h
};

/// Maximum of IsolineOptions::SteinerPoints.
constexpr int MaximumSteinerPoints = 50;

struct IsolineOptions
{
  IsolineMethod Method = IsolineMethod::LocalSources;
  /// Largest distance of a line from the level set, model units, at least 0; 0 means a thousandth
  /// of the mean edge length.
  double ChordTolerance = 0.0;
  /// Number of points per edge at which the distance is sampled, from 0 to MaximumSteinerPoints:
  /// the accuracy setting of Apollonius (ChordTolerance applies to LocalSources only). More points
  /// approximate the field better.
  int SteinerPoints = 2;
};

/// Polylines on a surface, in order of increasing levels.
struct Isolines
{
  std::vector<SurfacePath> Lines;
  std::vector<Id> Levels;     ///< per line, the index of its level
  std::vector<bool> IsClosed; ///< per line; a closed line repeats its first point at the end
  /// Number of pieces within a face that may exceed the tolerance, for example where the field is
  /// discontinuous.
  Id Fallbacks = 0;
};

/// Traces the isolines of some levels (finite, in any order). Points at the level count as farther
/// than the level.
///
/// Lines are continuous across edges. They are closed unless they end on the boundary, at unreached
/// faces, or on non-manifold edges.
///
/// In addition, LocalSources guarantees that within faces the points of lines are at the level up
/// to rounding, if the field is continuous. In faces with windows or virtual sources, level sets
/// are circular arcs: points are distributed along the arcs, and the corners between arcs are
/// points of the line. Lower distances are on the left of a line, with respect to the orientation
/// of its first face.
///
/// The result does not depend on `parallel`. After a failure, `lines` must not be used.
DGG_CORE_EXPORT Status TraceIsolines(const DistanceField& field, const std::vector<double>& levels,
  const IsolineOptions& options, const ParallelFor& parallel, const ProgressCallback& progress,
  Isolines& lines);
}

#endif
