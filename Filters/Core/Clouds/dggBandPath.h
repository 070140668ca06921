// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Smooth, shortened paths over a point cloud.
#ifndef dggBandPath_h
#define dggBandPath_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggGeodesicGraph.h" // for GraphView
#include "dggPoint3.h"        // for Point3
#include "dggStatus.h"        // for Status

#include <vector> // for the path

namespace dgg
{
/// A polyline close to the surface that a cloud was sampled from.
struct BandPath
{
  std::vector<Point3> Points; ///< from start to end
  std::vector<Id> Vertices;   ///< per point, its id if it is a cloud point, otherwise NoId
  double Length = 0.0;        ///< length of the polyline
};

/// Shortens and smooths paths through points of a cloud. Cloud points along edges are added, and
/// all points are moved toward the midpoint of their neighbors and onto the surface fitted to the
/// surrounding cloud points. Neighborhoods come from the graph, so no search tree is needed.
///
/// Every point and every midpoint of a segment stays within 1.5 spacings of a cloud point (in its
/// ball), so that a path crosses no wider gap than graph edges do. No point leaves the convex hull
/// of the cloud points within three spacings; without this constraint a path could cut the corner
/// at a boundary or a hole.
class DGG_CORE_EXPORT BandPathShortener
{
public:
  /// Stores pointers to `points` (x y z each), the graph of the cloud and `radii`
  /// (CloudGraph::Radii), which must outlive the object. The spacing of a point is its radius
  /// divided by AutomaticBallBySpacing.
  BandPathShortener(const double* points, const GraphView& graph, const double* radii);

  /// Shortens a path, given by its `vertices` from start to end. If `start` or `end` is not null,
  /// the path begins or ends at this position rather than at its first or last vertex. Fails if a
  /// vertex does not exist. `path` is empty after a failure or an abort. May be called by several
  /// threads simultaneously.
  Status Shorten(const std::vector<Id>& vertices, const Point3* start, const Point3* end,
    BandPath& path, const ProgressCallback& progress = {}) const;

private:
  class Relaxation;

  const double* Points;
  GraphView Graph;
  const double* Radii;
};
}

#endif
