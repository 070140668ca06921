// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How large the balls and the voxels of a band are. Internal.
#ifndef dggBandSizes_h
#define dggBandSizes_h

#include "dggCloudNodes.h" // for CloudNodes
#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPoint3.h"     // for Point3
#include "dggTypes.h"      // for Id, Status

#include <cstddef> // for std::size_t
#include <vector>  // for radii

namespace dgg
{
/// The neighbour whose distance gives the local spacing.
constexpr std::size_t SpacingNeighbors = 16;
/// Voxels along the longest side that can be asked for.
constexpr Id LargestResolution = 1 << 19;

/// Automatic ratio of ball radius to spacing. For random samples the balls cover all but 1/10000 of
/// the surface.
constexpr double AutomaticBallBySpacing = 1.5;

/// The root of the area that a point has, given its k-th neighbour.
DGG_CORE_EXPORT double SpacingFrom(double squaredDistance, std::size_t k);

/// The spacing of a point, given that of its nearest ones too, its own included, which are
/// reordered, and their squared distances in ascending order: a point on its own, far off the
/// surface, must not get a ball that reaches it, nor one at a border a larger one.
DGG_CORE_EXPORT float SmoothSpacing(
  float spacing, const std::vector<double>& squaredDistances, std::vector<float>& around);

struct BandOptions
{
  double OffsetInVoxels = 0.0; ///< radius of balls; 0 for one that follows the spacing
  Id Resolution = 0;           ///< voxels along the longest side; 0 for an automatic one
  double BallBySpacing = AutomaticBallBySpacing;
};

struct BandSizes
{
  std::vector<double> Radii; ///< per node
  double MedianRadius = 0.0; ///< in voxels
  double VoxelSize = 0.0;
  Id Resolution = 0; ///< voxels along the longest side
};

/// Choose sizes, in units of nodes, for their places and spacings. Fails where parts of the cloud
/// are too far apart.
DGG_CORE_EXPORT Status ChooseBandSizes(const CloudNodes& nodes, const std::vector<Point3>& places,
  const std::vector<float>& spacings, const BandOptions& options, BandSizes& sizes);
}

#endif
