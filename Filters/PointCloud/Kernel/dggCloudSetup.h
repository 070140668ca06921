// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What has to be known of a cloud before its graph can be built. Internal.
#ifndef dggCloudSetup_h
#define dggCloudSetup_h

#include "dggCloudGraphBuilder.h" // for options and statistics
#include "dggCloudNeighbors.h"    // for CloudNeighbors
#include "dggCloudNodes.h"        // for CloudNodes
#include "dggCloudPairs.h"        // for CloudPairs

#include <cstddef> // for std::size_t
#include <memory>  // for CloudNeighbors

namespace dgg
{
/// The neighbour whose distance tells the local spacing.
constexpr std::size_t SpacingNeighbors = 16;
/// That can be asked for.
constexpr Id LargestResolution = 1 << 19;

/// Everything up to the rows.
struct CloudSetup
{
  CloudNodes Nodes;
  CloudPairs Pairs;
  std::unique_ptr<CloudNeighbors> Neighbors;
  std::size_t NormalsMemory = 0; ///< bytes of those that were given

  std::size_t GetMemorySize() const;
  /// Bytes for so many nodes, but for the band.
  static std::size_t PredictMemory(std::size_t nodes);
};

/// Fails when that many bytes are more than the limit.
Status CheckSetupMemory(std::size_t bytes, const CloudGraphOptions& options);

/// `progress` is told of the fraction of this step.
Status SetUpCloud(const double* points, Id numberOfPoints, const CloudGraphOptions& options,
  const ProgressCallback& progress, CloudSetup& setup, CloudGraphStatistics& statistics);
}

#endif
