// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What has to be known of a cloud before its graph can be built. Internal.
#ifndef dggCloudSetup_h
#define dggCloudSetup_h

#include "dggBandSizes.h"         // for SpacingNeighbors
#include "dggCloudGraphBuilder.h" // for options and statistics
#include "dggCloudNeighbors.h"    // for CloudNeighbors
#include "dggCloudNodes.h"        // for CloudNodes
#include "dggCloudPairs.h"        // for CloudPairs

#include <cstddef> // for std::size_t
#include <memory>  // for CloudNeighbors
#include <vector>  // for curvatures

namespace dgg
{
/// Everything up to the rows.
struct CloudSetup
{
  CloudNodes Nodes;
  CloudPairs Pairs;
  std::unique_ptr<CloudNeighbors> Neighbors;
  std::size_t NormalsMemory = 0; ///< bytes of those that were given

  /// Bytes held, about.
  std::size_t GetMemorySize() const;
  /// Bytes while the nodes of so many points are found.
  std::size_t GetMemoryBefore(Id numberOfPoints) const;
};

class SetupLoop;

/// Choose the radii of balls and the size of voxels, mark the band, and find the nearest point of
/// each of its voxels. Needs the spacings of the nodes and the tree of them. Fails when parts of
/// the cloud are too far apart, when the band does not fit into the memory, and when stopped.
Status BuildCloudBand(const CloudGraphOptions& options, SetupLoop& loop, CloudSetup& setup,
  CloudGraphStatistics& statistics);

/// Choose the reach of each node by the scheme. Needs all else of the pairs, and `curvatures` of
/// the surface at the nodes.
void ChooseReaches(const CloudGraphOptions& options, double medianSpacing,
  const std::vector<float>& curvatures, SetupLoop& loop, CloudSetup& setup,
  CloudGraphStatistics& statistics);

/// Fails when that many bytes are more than the limit.
Status CheckSetupMemory(std::size_t bytes, const CloudGraphOptions& options);

/// `progress` receives the fraction of this step.
Status SetUpCloud(const double* points, Id numberOfPoints, const CloudGraphOptions& options,
  const ProgressCallback& progress, CloudSetup& setup, CloudGraphStatistics& statistics);
}

#endif
