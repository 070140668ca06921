// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudNeighbors.h"

#define NANOFLANN_NO_THREADS // builds trees in the calling thread alone
#include <nanoflann.hpp>

#include <algorithm>
#include <limits>

namespace dgg
{
namespace
{
/// The points, in the form that nanoflann requires.
struct Positions
{
  const std::vector<Point3>& Points;

  std::size_t kdtree_get_point_count() const { return this->Points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const
  {
    const Point3& p = this->Points[i];
    return axis == 0 ? p.X : axis == 1 ? p.Y : p.Z;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false; // nanoflann computes it
  }
};

static_assert(sizeof(Point3) == 3 * sizeof(double), "nanoflann reads a point as three numbers");

using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Positions>,
  Positions, 3, Id>;

/// A function object rather than a function, so that calls are inlined.
constexpr auto IsCloser = [](const CloudNeighbor& a, const CloudNeighbor& b) {
  return a.SquaredDistance != b.SquaredDistance ? a.SquaredDistance < b.SquaredDistance
                                                : a.Point < b.Point;
};

/// Returns a slightly larger bound. nanoflann visits only points closer than the bound, which would
/// exclude points exactly at that distance.
double Enlarge(double squaredDistance)
{
  return squaredDistance * (1.0 + 1e-12) + std::numeric_limits<double>::min();
}

/// The nearest points found so far: a heap with the farthest of them on top.
class NearestSet
{
public:
  using DistanceType = double;
  using IndexType = Id;

  NearestSet(std::size_t most, double squaredRadius, std::vector<CloudNeighbor>& neighbors)
    : Most(most)
    , SquaredRadius(squaredRadius)
    , Neighbors(neighbors)
  {
    this->Neighbors.clear();
  }

  bool full() const { return true; }
  void sort() {} // by Find()

  /// Returns true: the search continues.
  bool addPoint(double squaredDistance, Id point)
  {
    const CloudNeighbor neighbor{ point, squaredDistance };
    if (this->Neighbors.size() < this->Most)
    {
      if (squaredDistance <= this->SquaredRadius)
      {
        this->Neighbors.push_back(neighbor);
        if (this->Neighbors.size() == this->Most)
        {
          std::make_heap(this->Neighbors.begin(), this->Neighbors.end(), IsCloser);
        }
      }
    }
    else if (IsCloser(neighbor, this->Neighbors.front()))
    {
      std::pop_heap(this->Neighbors.begin(), this->Neighbors.end(), IsCloser);
      this->Neighbors.back() = neighbor;
      std::push_heap(this->Neighbors.begin(), this->Neighbors.end(), IsCloser);
    }
    return true;
  }

  double worstDist() const
  {
    const double farthest = this->Neighbors.size() < this->Most
      ? this->SquaredRadius
      : this->Neighbors.front().SquaredDistance;
    return Enlarge(farthest);
  }

private:
  std::size_t Most;
  double SquaredRadius;
  std::vector<CloudNeighbor>& Neighbors;
};

/// Counts the points within a radius.
class Counter
{
public:
  using DistanceType = double;
  using IndexType = Id;

  explicit Counter(double squaredRadius)
    : SquaredRadius(squaredRadius)
  {
  }

  std::size_t GetCount() const { return this->Count; }
  bool full() const { return true; }
  void sort() {}
  bool addPoint(double squaredDistance, Id)
  {
    this->Count += squaredDistance <= this->SquaredRadius ? 1 : 0;
    return true;
  }
  double worstDist() const { return Enlarge(this->SquaredRadius); }

private:
  double SquaredRadius;
  std::size_t Count = 0;
};
}

class CloudNeighbors::Tree
{
public:
  explicit Tree(const std::vector<Point3>& points)
    : Places{ points }
    , Nodes(3, this->Places, nanoflann::KDTreeSingleIndexAdaptorParams(12))
  {
  }

  void Find(const Point3& place, std::size_t most, double squaredRadius,
    std::vector<CloudNeighbor>& neighbors) const
  {
    NearestSet set(most, squaredRadius, neighbors);
    if (most > 0)
    {
      this->Nodes.findNeighbors(set, &place.X, {});
    }
    std::sort(neighbors.begin(), neighbors.end(), IsCloser);
  }

  std::size_t Count(const Point3& place, double squaredRadius) const
  {
    Counter counter(squaredRadius);
    this->Nodes.findNeighbors(counter, &place.X, {});
    return counter.GetCount();
  }

private:
  Positions Places;
  Index Nodes;
};

CloudNeighbors::CloudNeighbors(const std::vector<Point3>& points)
  : KdTree(std::make_unique<Tree>(points))
{
}

CloudNeighbors::~CloudNeighbors() = default;

void CloudNeighbors::FindNearest(
  const Point3& place, std::size_t count, std::vector<CloudNeighbor>& neighbors) const
{
  this->KdTree->Find(place, count, std::numeric_limits<double>::max() / 4.0, neighbors);
}

void CloudNeighbors::FindWithin(
  const Point3& place, double radius, std::vector<CloudNeighbor>& neighbors) const
{
  this->KdTree->Find(place, std::numeric_limits<std::size_t>::max(), radius * radius, neighbors);
}

std::size_t CloudNeighbors::CountWithin(const Point3& place, double radius) const
{
  return this->KdTree->Count(place, radius * radius);
}
}
