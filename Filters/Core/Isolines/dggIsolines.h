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
/// How the distance runs inside of faces.
enum class IsolineMethod
{
  LocalSources, ///< as DistanceField says
  Apollonius    ///< as published, for comparison: dggApolloniusFace.h
};

/// Most of IsolineOptions::SteinerPoints.
constexpr int MaximumSteinerPoints = 50;

struct IsolineOptions
{
  IsolineMethod Method = IsolineMethod::LocalSources;
  /// How far a line may be from the level set, a length; 0 means a thousandth of the mean edge
  /// length.
  double ChordTolerance = 0.0;
  /// Of Apollonius, as ChordTolerance is of LocalSources: points per edge that the distance comes
  /// from; more of them come closer to the field.
  int SteinerPoints = 2;
};

/// Polylines on a surface, in order of increasing levels.
struct Isolines
{
  std::vector<SurfacePath> Lines;
  std::vector<Id> Levels;     ///< per line, the index of its level
  std::vector<bool> IsClosed; ///< per line: then it ends with the point that it starts with
  /// Pieces within one face that may be farther from the level set than the tolerance, as where the
  /// field is not continuous.
  Id Fallbacks = 0;
};

/// Find all points of some distances, finite ones in any order. Points at the level count as
/// farther away than it.
///
/// Lines are continuous across edges. They are closed but for those that end on the boundary, at
/// faces that are not reached, and on edges with more than two faces.
///
/// Of LocalSources this holds besides: within faces the points of lines are at the level up to
/// rounding, where the field is continuous. Where level sets are arcs of
/// circles, in faces with windows or virtual sources, points are spread along these; the corners
/// between arcs are points of the line. Lower distances are on the left of a line, as seen with the
/// orientation of the face that it starts in.
///
/// The result does not depend on `parallel`.
DGG_CORE_EXPORT Status TraceIsolines(const DistanceField& field, const std::vector<double>& levels,
  const IsolineOptions& options, const ParallelFor& parallel, const ProgressCallback& progress,
  Isolines& lines);
}

#endif
