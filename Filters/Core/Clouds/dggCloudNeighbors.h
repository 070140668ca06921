// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Neighbor searches in a cloud with nanoflann. Internal.
#ifndef dggCloudNeighbors_h
#define dggCloudNeighbors_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPoint3.h"     // for Point3
#include "dggTypes.h"      // for Id

#include <cstddef> // for std::size_t
#include <memory>  // for the kd-tree
#include <vector>  // for results

namespace dgg
{
struct CloudNeighbor
{
  Id Point = NoId;
  double SquaredDistance = 0.0;
};

/// A kd-tree of points. The points must outlive the tree. Searches are exact and may run in several
/// threads simultaneously. Results are sorted by distance; points at equal distance are sorted by
/// id. Points must be finite, and squared distances must be within the range of double.
class DGG_CORE_EXPORT CloudNeighbors
{
public:
  explicit CloudNeighbors(const std::vector<Point3>& points);
  ~CloudNeighbors();
  CloudNeighbors(const CloudNeighbors&) = delete;
  CloudNeighbors& operator=(const CloudNeighbors&) = delete;

  /// Finds the `count` points nearest to a position, including a point at the position itself;
  /// fewer if the cloud has fewer points.
  void FindNearest(
    const Point3& place, std::size_t count, std::vector<CloudNeighbor>& neighbors) const;

  /// Finds all points at a distance of at most `radius`.
  void FindWithin(const Point3& place, double radius, std::vector<CloudNeighbor>& neighbors) const;

  /// Returns the number of points that FindWithin() would find.
  std::size_t CountWithin(const Point3& place, double radius) const;

private:
  class Tree;
  std::unique_ptr<Tree> KdTree;
};
}

#endif
