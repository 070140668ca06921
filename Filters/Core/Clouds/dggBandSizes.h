// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sizes of the balls and voxels of a band. Internal.
#ifndef dggBandSizes_h
#define dggBandSizes_h

#include "dggCloudNeighbors.h" // for CloudNeighbor
#include "dggCloudNodes.h"     // for CloudNodes
#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggPoint3.h"         // for Point3
#include "dggStatus.h"         // for Status

#include <cstddef> // for std::size_t
#include <vector>  // for radii

namespace dgg
{
/// Rank of the neighbor whose distance defines the local spacing.
constexpr std::size_t SpacingNeighbors = 16;
/// Maximum number of voxels along the longest side.
constexpr Id LargestResolution = 1 << 19;

/// Automatic ratio of ball radius to spacing. For random samples the balls cover all but 1/10000 of
/// the surface.
constexpr double AutomaticBallBySpacing = 1.5;

/// Returns the spacing, the square root of the area per point, from the squared distance of the
/// k-th neighbor.
DGG_CORE_EXPORT double SpacingFrom(double squaredDistance, std::size_t k);

/// Returns a robust spacing of a point from its spacing, its nearest neighbors (including the point
/// itself, by ascending distance) and the spacings of all points. An isolated point far off the
/// surface must not get a ball that reaches the surface, and a boundary point must not get a larger
/// ball than its neighbors.
DGG_CORE_EXPORT float SmoothSpacing(
  float spacing, const std::vector<CloudNeighbor>& neighbors, const std::vector<float>& spacings);

struct BandOptions
{
  double OffsetInVoxels = 0.0; ///< radius of balls; 0 derives it from the spacing
  Id Resolution = 0;           ///< voxels along the longest side; 0 for automatic
  double BallBySpacing = AutomaticBallBySpacing;
};

struct BandSizes
{
  std::vector<double> Radii; ///< per node
  double MedianRadius = 0.0; ///< in voxels
  double VoxelSize = 0.0;
  Id Resolution = 0; ///< voxels along the longest side
};

/// Chooses sizes, in units of nodes, from the positions and spacings of the nodes. Fails if parts
/// of the cloud are too far apart.
DGG_CORE_EXPORT Status ChooseBandSizes(const CloudNodes& nodes, const std::vector<Point3>& places,
  const std::vector<float>& spacings, const BandOptions& options, BandSizes& sizes);
}

#endif
