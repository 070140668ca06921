// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Takes triangles of zero area out of a triangulation without a change of the surface.
#ifndef dggCapSplitting_h
#define dggCapSplitting_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggTypes.h"      // for Id

#include <vector> // for the triangles

namespace dgg
{
/// What SplitCaps() has done.
struct CapSplitting
{
  Offset NumberOfCaps = 0;    ///< left out
  double LargestHeight = 0.0; ///< sum of those that lie on each other: no point has moved farther
};

/// A *cap* is a triangle whose apex lies on its longest edge, up to rounding: a doubled segment, as
/// CAD programs leave it where a point of one face meets the middle of an edge of another. All
/// other triangles on the long edge are split at the apex, and the cap is left out. A cap that is
/// alone on its long edge is left out where both short edges have other triangles.
///
/// The surface stays where it is, up to the heights of the caps, and so do its points; edges and
/// triangles then have the lengths and areas that their points give them. What is no cap but
/// degenerate, as triangles with an edge of zero length, stays and is left to
/// SurfaceMesh::FromPoints(), as are caps that do not end within a few times the number of
/// triangles.
///
/// `points` are x y z each, finite. `triangles` are triples of their ids. `parents[f]` becomes the
/// input triangle that triangle f is, or is a part of.
DGG_CORE_EXPORT CapSplitting SplitCaps(
  const double* points, std::vector<Id>& triangles, std::vector<Id>& parents);

/// Slack of the triangle inequality below which a triangle is degenerate, relative to the longest
/// of its edges or the mean edge of the mesh, whichever is longer.
constexpr double DegeneracySlack = 1e-13;
}

#endif
