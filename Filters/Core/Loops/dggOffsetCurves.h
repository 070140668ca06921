// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Offset curves at a given distance from a curve.
#ifndef dggOffsetCurves_h
#define dggOffsetCurves_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggSurfacePath.h" // for SurfacePath

#include <vector> // for the rims

namespace dgg
{
/// Computes the boundary curves of a band of the given width around a path or a loop: the curves at
/// a distance of half the width. A loop has one curve on each side, if the side is wide enough; a
/// path has one curve around it, and more if it crosses itself. Offset curves end at the boundary
/// of the surface.
///
/// The curves are isolines (dggIsolines.h) of the exact distance from points on the path. These
/// points are so dense that the distance is accurate to 1e-5. Points of a curve have the same
/// accuracy; segments between them are straight within one face, and deviate by at most a
/// thousandth of the distance. Closed curves shorter than a quarter of the width are discarded.
///
/// Fails if the path is not on the mesh, or the width is not finite or below
/// GetSmallestOffsetWidth().
DGG_CORE_EXPORT Status MakeOffsetCurves(const SurfaceMesh& mesh, const SurfacePath& path,
  double width, const ProgressCallback& progress, std::vector<SurfacePath>& rims);

/// Returns the minimum width of a band along a path, a fraction of the length of the path.
DGG_CORE_EXPORT double GetSmallestOffsetWidth(const SurfacePath& path);
}

#endif
