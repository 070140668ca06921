// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Fast marching in the band of voxels around a cloud. Internal.
#ifndef DGGCloudMarching_h
#define DGGCloudMarching_h

#include "dggBandMarching.h" // for the march
#include "dggBandSizes.h"    // for the options of the band
#include "dggCloudNodes.h"   // for the points

#include <memory> // for the march
#include <vector> // for places

struct DGGContext;
struct DGGDistanceTask;

/// Solver for a cloud, prepared once for its points and the options of its band.
class DGGCloudMarching
{
public:
  /// Builds the band. `progress` receives the fraction of this step.
  dgg::Status Prepare(const DGGContext& context, const dgg::BandOptions& options,
    const dgg::ProgressCallback& progress);

  /// Fills distances and nearest sources. Outliers and points with non-finite coordinates are
  /// reached only by sources at these points; copies of a point have its distance. A source outside
  /// the band starts at the closest point of the cloud.
  dgg::Status Run(DGGDistanceTask& task, const dgg::ProgressCallback& progress) const;

  /// Returns the median radius of balls, in voxels.
  double GetBandRadius() const { return this->BandRadius; }
  /// Returns the number of voxels along the longest side of the points.
  dgg::Id GetResolution() const { return this->Resolution; }

private:
  void NumberPlaces(dgg::Id numberOfPoints);

  dgg::CloudNodes Nodes;
  std::vector<dgg::Point3> Places; // positions of nodes
  std::vector<dgg::Id> PlaceOf;    // per point: a node, an outlier (numbered after nodes) or NoId
  dgg::VoxelBand Band;
  std::unique_ptr<dgg::BandMarching> Marching;
  double BandRadius = 0.0;
  dgg::Id Resolution = 0;
};

#endif
