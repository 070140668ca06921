// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths over a point cloud that do not zigzag from point to point.
#ifndef dggBandPath_h
#define dggBandPath_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggGeodesicGraph.h" // for GraphView
#include "dggPoint3.h"        // for Point3
#include "dggTypes.h"         // for Id, Status

#include <vector> // for the path

namespace dgg
{
/// A polyline close to the surface that a cloud was sampled from.
struct BandPath
{
  std::vector<Point3> Points; ///< from start to end
  std::vector<Id> Vertices;   ///< per point, the point of the cloud that it is, or NoId
  double Length = 0.0;        ///< of the polyline
};

/// Makes paths through points of a cloud shorter and smooth. The points of the cloud along edges
/// are added, and all are moved toward the midpoint of their neighbors and onto the surface fitted
/// to the points of the cloud around them. Neighborhoods come from the graph, so no search tree is
/// needed.
///
/// Every point and every midpoint of a segment stays within 1.5 spacings of a point of the cloud
/// (in its ball), so that a path crosses no wider gap than edges of the graph do. No point moves
/// out of the convex hull of the points of the cloud within three spacings: at a rim or a hole,
/// balls alone would let it cut the corner.
class DGG_CORE_EXPORT BandPathShortener
{
public:
  /// `points` (x y z each), the graph of the cloud and `radii` (CloudGraph::Radii) must outlive it.
  /// The spacing of a point is its radius by AutomaticBallBySpacing.
  BandPathShortener(const double* points, const GraphView& graph, const double* radii);

  /// Shortens a path, `vertices` from start to end. With `start` or `end`, which may be null, the
  /// path begins or ends there rather than at its first or last vertex. Fails if a vertex does not
  /// exist. `path` is then empty, as after an abort. May be called by several threads
  /// simultaneously.
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
