// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Neighbours of points of a cloud, by FLANN. Internal.
#ifndef dggCloudNeighbors_h
#define dggCloudNeighbors_h

#include "dggPoint3.h" // for Point3
#include "dggTypes.h"  // for Id

#include <cstddef> // for std::size_t
#include <memory>  // for FLANN's index
#include <vector>  // for results

namespace dgg
{
struct CloudNeighbor
{
  Id Point = NoId;
  double SquaredDistance = 0.0;
};

/// A kd-tree of points, which must outlive it. Searches are exact and may run in several threads at
/// once. Results are sorted by distance, and by number where distances are equal. Points have to be
/// finite, and squares of distances within the range of double.
class CloudNeighbors
{
public:
  explicit CloudNeighbors(const std::vector<Point3>& points);
  ~CloudNeighbors();
  CloudNeighbors(const CloudNeighbors&) = delete;
  CloudNeighbors& operator=(const CloudNeighbors&) = delete;

  /// The `count` nearest points, the place itself included when there is a point; fewer when there
  /// are no more.
  void FindNearest(
    const Point3& place, std::size_t count, std::vector<CloudNeighbor>& neighbors) const;

  /// All points not farther than a radius.
  void FindWithin(const Point3& place, double radius, std::vector<CloudNeighbor>& neighbors) const;

  /// How many FindWithin() would find.
  std::size_t CountWithin(const Point3& place, double radius) const;

private:
  class Tree;
  std::unique_ptr<Tree> Index;
};
}

#endif
