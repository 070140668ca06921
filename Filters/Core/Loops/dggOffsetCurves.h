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
/// The distance is the exact one from points on the path, so close that it is right to 1e-5 of it.
/// Points of a rim are as exact; between them it is straight, in one face. They are where it
/// crosses edges, after long ones have been split into pieces of at most a tenth of the width, and
/// a hundredth at corners of rims, so that the length of a rim is right to about 1e-3. Rims that
/// are shorter than the width may be missed.
///
/// Fails when the path is not on the mesh, or the width is not finite, or below
/// GetSmallestOffsetWidth().
DGG_CORE_EXPORT Status MakeOffsetCurves(const SurfaceMesh& mesh, const SurfacePath& path,
  double width, const ProgressCallback& progress, std::vector<SurfacePath>& rims);

/// The width of a tape along a path must be at least this, a part of the length of the path.
DGG_CORE_EXPORT double GetSmallestOffsetWidth(const SurfacePath& path);
}

#endif
