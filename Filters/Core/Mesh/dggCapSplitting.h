// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Removes triangles of zero area from a triangulation without changing the surface.
#ifndef dggCapSplitting_h
#define dggCapSplitting_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggTypes.h"      // for Id

#include <vector> // for the triangles

namespace dgg
{
/// Result of SplitCaps().
struct CapSplitting
{
  Offset NumberOfCaps = 0;    ///< number of removed caps
  double LargestHeight = 0.0; ///< largest sum of heights of stacked caps: no point moves farther
};

/// A *cap* is a triangle whose apex lies on its longest edge, up to rounding: a doubled segment, as
/// produced by CAD programs where a vertex of one face lies in the interior of an edge of another
/// face. All other triangles on the long edge are split at the apex, and the cap is removed. A cap
/// that is the only triangle on its long edge is removed if both short edges have other triangles.
/// The surface does not change, up to the heights of the caps, and points do not move; afterwards
/// edges and triangles have the lengths and areas that their points imply. Other degenerate
/// triangles, such as those with an edge of zero length, are not changed. Caps also remain once
/// splitting has multiplied the number of triangles a few times. Both are left to
/// SurfaceMesh::FromPoints().
///
/// `points` are x y z each, finite. `triangles` are triples of their ids. `parents[f]` becomes the
/// input triangle that contains triangle f.
DGG_CORE_EXPORT CapSplitting SplitCaps(
  const double* points, std::vector<Id>& triangles, std::vector<Id>& parents);

/// Slack of the triangle inequality below which a triangle is degenerate, relative to the longest
/// of its edges or the mean edge of the mesh, whichever is longer.
constexpr double DegeneracySlack = 1e-13;
}

#endif
