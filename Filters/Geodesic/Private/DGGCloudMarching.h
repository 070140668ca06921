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

/// What is prepared once for the points of a cloud and the options of its band.
class DGGCloudMarching
{
public:
  /// `progress` receives the fraction of this step.
  dgg::Status Prepare(const DGGContext& context, const dgg::BandOptions& options,
    const dgg::ProgressCallback& progress);

  /// Fills distances and nearest sources. Outliers, and points that are not finite, are reached by
  /// sources at them only; copies of a point have its distance. A source beside the band starts at
  /// the point that it is closest to.
  dgg::Status Run(DGGDistanceTask& task, const dgg::ProgressCallback& progress) const;

  /// Median radius of balls, in voxels.
  double GetBandRadius() const { return this->BandRadius; }
  /// Voxels along the longest side of the points.
  dgg::Id GetResolution() const { return this->Resolution; }

private:
  void NumberPlaces(dgg::Id numberOfPoints);

  dgg::CloudNodes Nodes;
  std::vector<dgg::Point3> Places; // of nodes
  std::vector<dgg::Id> PlaceOf;    // per point: a node, or beyond these an outlier, or dgg::NoId
  dgg::VoxelBand Band;
  std::unique_ptr<dgg::BandMarching> Marching;
  double BandRadius = 0.0;
  dgg::Id Resolution = 0;
};

#endif
