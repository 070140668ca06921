// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Data of a cloud that are needed before its graph can be built. Internal.
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
/// Input of the row construction: nodes, pair queries and neighbor search.
struct CloudSetup
{
  CloudNodes Nodes;
  CloudPairs Pairs;
  std::unique_ptr<CloudNeighbors> Neighbors;
  std::size_t NormalsMemory = 0; ///< memory of the given normals in bytes

  /// Returns the approximate memory of this object and the given normals in bytes.
  std::size_t GetMemorySize() const;
  /// Returns the memory in bytes that is used while the nodes of `numberOfPoints` points are found.
  std::size_t GetMemoryBefore(Id numberOfPoints) const;
};

class SetupLoop;

/// Chooses ball radii and voxel size, marks the band, and finds the nearest point of each of its
/// voxels. Requires the spacings of the nodes and their kd-tree. Fails if parts of the cloud are
/// too far apart, if the band exceeds the memory limit, or if stopped.
Status BuildCloudBand(const CloudGraphOptions& options, SetupLoop& loop, CloudSetup& setup,
  CloudGraphStatistics& statistics);

/// Chooses the reach of each node by the scheme. Requires all other data of the pairs, and
/// `curvatures` of the surface at the nodes.
void ChooseReaches(const CloudGraphOptions& options, double medianSpacing,
  const std::vector<float>& curvatures, SetupLoop& loop, CloudSetup& setup,
  CloudGraphStatistics& statistics);

/// Fails if `bytes` exceeds the memory limit.
Status CheckSetupMemory(std::size_t bytes, const CloudGraphOptions& options);

/// Prepares a cloud for the row construction. `progress` receives the fraction of this step. Fails
/// if the coordinates are too large, if the band cannot be built, if the memory limit is exceeded,
/// or if `progress` returns false.
Status SetUpCloud(const double* points, Id numberOfPoints, const CloudGraphOptions& options,
  const ProgressCallback& progress, CloudSetup& setup, CloudGraphStatistics& statistics);
}

#endif
