// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What has to be known of a cloud before its graph can be built. Internal.
#ifndef dggCloudSetup_h
#define dggCloudSetup_h

#include "dggCloudGraphBuilder.h" // for options and statistics
#include "dggCloudNeighbors.h"    // for CloudNeighbors
#include "dggCloudPairs.h"        // for CloudPairs

#include <memory>  // for CloudNeighbors
#include <utility> // for std::pair
#include <vector>  // for nodes

namespace dgg
{
/// The points that a graph is built of, the nodes: finite, no two in the same place, those that are
/// close to each other close in memory. Their coordinates are centred and scaled by a power of two
/// to [-1, 1].
struct CloudNodes
{
  /// Per node, the point with the smallest number that is there.
  std::vector<Id> Originals;
  /// Other points: their number, and the node in the same place.
  std::vector<std::pair<Id, Id>> Coincident;
  Id Unused = 0;
  double Scale = 1.0;  ///< from units of the points to units of nodes
  double Extent = 0.0; ///< longest side of the box of the nodes
};

/// Find the nodes of a cloud. Fails where coordinates are too large for double arithmetic.
Status FindNodes(
  const double* points, Id numberOfPoints, CloudNodes& nodes, std::vector<Point3>& places);

/// Everything up to the rows.
struct CloudSetup
{
  CloudNodes Nodes;
  CloudPairs Pairs;
  std::unique_ptr<CloudNeighbors> Neighbors;
  /// Neighbours of a point that are looked at, at most.
  std::size_t MostNeighbors = 0;

  std::size_t GetMemorySize() const;
};

/// `progress` is told of the fraction of this step.
Status SetUpCloud(const double* points, Id numberOfPoints, const CloudGraphOptions& options,
  const ProgressCallback& progress, CloudSetup& setup, CloudGraphStatistics& statistics);
}

#endif
