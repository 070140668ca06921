// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Curves at a distance from a curve.
#ifndef dggOffsetCurves_h
#define dggOffsetCurves_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggSurfacePath.h" // for SurfacePath

#include <vector> // for the rims

namespace dgg
{
/// The rims of a tape of the given width that is laid along a path or a loop: the curves at a
/// distance of half of the width from it. A loop has one on each side, where there is room; around
/// a path there is one; where the path crosses itself, there are more. Rims end at the boundary of
/// the surface.
///
/// They are the isolines (dggIsolines.h) of the exact distance from points on the path, so close
/// that it is right to 1e-5 of it. Points of a rim are as exact; between them it is straight, in
/// one face, and no farther from the curve than a thousandth of the distance. Closed rims that are
/// shorter than a quarter of the width are left out.
///
/// Fails when the path is not on the mesh, or the width is not finite, or below
/// GetSmallestOffsetWidth().
DGG_CORE_EXPORT Status MakeOffsetCurves(const SurfaceMesh& mesh, const SurfacePath& path,
  double width, const ProgressCallback& progress, std::vector<SurfacePath>& rims);

/// The width of a tape along a path must be at least this, a part of the length of the path.
DGG_CORE_EXPORT double GetSmallestOffsetWidth(const SurfacePath& path);
}

#endif
