// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths over a point cloud that do not zigzag from point to point.
#ifndef dggBandPath_h
#define dggBandPath_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggGeodesicGraph.h" // for GraphView
#include "dggParallel.h"      // for ParallelFor
#include "dggPoint3.h"        // for Point3
#include "dggVoxelBand.h"     // for VoxelBand

#include <cstddef> // for std::size_t
#include <vector>  // for the path

namespace dgg
{
/// A polyline close to the surface that a cloud was sampled from.
struct BandPath
{
  std::vector<Point3> Points; ///< from start to end
  std::vector<Id> Vertices;   ///< per point, the point of the cloud that it is, or NoId
  double Length = 0.0;        ///< of the polyline
};

/// Makes paths through points of a cloud shorter and smooth. Points are put between those of the
/// path, about as far apart as those of the cloud, and moved to and fro: to the middle of their
/// neighbours, and back to the surface that is fitted to the points of the cloud around them. None
/// leaves the band. Neighbours come from the graph, so no search tree is needed.
class DGG_CORE_EXPORT BandPathShortener
{
public:
  /// `points` (x y z each), the graph of the cloud and `radii` (CloudGraph::Radii) must outlive it.
  BandPathShortener(const double* points, const GraphView& graph, const double* radii);

  /// Rebuild the band, in at most `memoryLimit` bytes (0: no limit). Fails as VoxelBand::Build()
  /// does.
  Status Prepare(double voxelSize, std::size_t memoryLimit, const ParallelFor& parallel,
    const ProgressCallback& progress = {});
  std::size_t GetMemorySize() const { return this->Band.GetMemorySize(); }

  /// Shorten a path, `vertices` from start to end. With `start` or `end`, which may be null, the
  /// path begins or ends there rather than at its first or last vertex. Fails when a vertex does
  /// not exist; `path` is empty then, and when `progress` asks to stop. May be called by several
  /// threads at once.
  Status Shorten(const std::vector<Id>& vertices, const Point3* start, const Point3* end,
    BandPath& path, const ProgressCallback& progress = {}) const;

private:
  class Relaxation;

  const double* Points;
  GraphView Graph;
  const double* Radii;
  VoxelBand Band;
};
}

#endif
