// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Fast marching in the band of voxels around a cloud. Internal.
#ifndef dggCloudMarching_h
#define dggCloudMarching_h

#include "dggBandMarching.h" // for the march
#include "dggBandSizes.h"    // for the options of the band
#include "dggCloudNodes.h"   // for the points
#include "dggCoreExport.h"   // for DGG_CORE_EXPORT

#include <memory> // for the march
#include <vector> // for places

namespace dgg
{
struct GeodesicSource;
struct MarchingResult;
struct TaskContext;

/// Solver for a cloud, prepared once for its points and the options of its band.
class DGG_CORE_EXPORT CloudMarching
{
public:
  /// Builds the band. `progress` receives the fraction of this step.
  Status Prepare(
    const TaskContext& context, const BandOptions& options, const ProgressCallback& progress);

  /// Computes distances and nearest sources. Points farther than `maximumDistance` may be left
  /// unreached. Outliers and points with non-finite coordinates are reached only by sources at
  /// these points; copies of a point have its distance. A source outside the band starts at the
  /// closest point of the cloud.
  Status Run(const TaskContext& context, const std::vector<GeodesicSource>& sources,
    double maximumDistance, const ProgressCallback& progress, MarchingResult& result) const;

  /// Returns the median radius of balls, in voxels.
  double GetBandRadius() const { return this->BandRadius; }
  /// Returns the number of voxels along the longest side of the points.
  Id GetResolution() const { return this->Resolution; }

private:
  void NumberPlaces(Id numberOfPoints);
  /// Returns the starts of the march. `indices` receives the index of the source of each start.
  std::vector<BandSource> FindStarts(
    const std::vector<GeodesicSource>& sources, std::vector<Id>& indices) const;

  CloudNodes Nodes;
  std::vector<Point3> Places; // positions of nodes
  std::vector<Id> PlaceOf;    // per point: a node, an outlier (numbered after nodes) or NoId
  VoxelBand Band;
  std::unique_ptr<BandMarching> Marching;
  double BandRadius = 0.0;
  Id Resolution = 0;
};
}

#endif
