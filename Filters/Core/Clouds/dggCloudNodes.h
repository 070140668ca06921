// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points of a cloud that count. Internal.
#ifndef dggCloudNodes_h
#define dggCloudNodes_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPoint3.h"     // for Point3
#include "dggTypes.h"      // for Id, Status

#include <utility> // for std::pair
#include <vector>  // for nodes

namespace dgg
{
/// The points that graphs are built of and marches start from, the nodes: finite, no outliers, no
/// two in the same place, those that are close to each other close in memory. Their coordinates are
/// centred and scaled by a power of two to [-1, 1].
struct CloudNodes
{
  /// Per node, the point with the smallest number that is there.
  std::vector<Id> Originals;
  /// Points that are far off all others (Outliers), those with the smallest numbers in their
  /// places.
  std::vector<Id> Outliers;
  /// Other points: their number, and that of the point above in the same place.
  std::vector<std::pair<Id, Id>> Coincident;
  Id Unused = 0;
  Id NumberOfOutliers = 0; ///< points, copies included
  double Scale = 1.0;      ///< from units of the points to units of nodes
  double Extent = 0.0;     ///< longest side of the box of the nodes
};

/// Find the nodes of a cloud. Fails where coordinates are too large for double arithmetic.
DGG_CORE_EXPORT Status FindNodes(
  const double* points, Id numberOfPoints, CloudNodes& nodes, std::vector<Point3>& places);
}

#endif
