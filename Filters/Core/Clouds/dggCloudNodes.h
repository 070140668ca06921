// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Nodes of a cloud: finite, distinct points without outliers. Internal.
#ifndef dggCloudNodes_h
#define dggCloudNodes_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPoint3.h"     // for Point3
#include "dggStatus.h"     // for Status

#include <utility> // for std::pair
#include <vector>  // for nodes

namespace dgg
{
/// Points on which graphs are built and from which marching starts. Nodes are finite, are no
/// outliers, and have distinct positions. Nodes that are close in space are close in memory.
/// Coordinates are centered and scaled by a power of two to [-1, 1].
struct CloudNodes
{
  /// Per node, the smallest id of the points at its position.
  std::vector<Id> Originals;
  /// Points far from all others (see class Outliers). Of several points at the same position, only
  /// the one with the smallest id is listed.
  std::vector<Id> Outliers;
  /// Remaining points, as pairs: the id of the point, and the id in Originals or Outliers of the
  /// point at the same position.
  std::vector<std::pair<Id, Id>> Coincident;
  Id Unused = 0;
  Id NumberOfOutliers = 0; ///< number of points, including duplicates
  double Scale = 1.0;      ///< factor from units of the points to units of nodes
  double Extent = 0.0;     ///< longest side of the bounding box of the nodes
};

/// Finds the nodes of a cloud. Fails if coordinates are too large for double arithmetic.
DGG_CORE_EXPORT Status FindNodes(
  const double* points, Id numberOfPoints, CloudNodes& nodes, std::vector<Point3>& places);
}

#endif
