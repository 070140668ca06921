// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudNeighbors.h"

#include <algorithm>
#include <limits>

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

namespace dgg
{
namespace
{
using Distance = flann::L2_3D<double>;

static_assert(sizeof(Point3) == 3 * sizeof(double), "FLANN reads points as rows of numbers");

/// A function object rather than a function, so that calls are inlined.
constexpr auto IsCloser = [](const CloudNeighbor& a, const CloudNeighbor& b) {
  return a.SquaredDistance != b.SquaredDistance ? a.SquaredDistance < b.SquaredDistance
                                                : a.Point < b.Point;
};

/// Returns a slightly larger bound. FLANN visits only points closer than the bound, which would
/// exclude points exactly at that distance.
double WithHair(double squaredDistance)
{
  return squaredDistance * (1.0 + 1e-12) + std::numeric_limits<double>::min();
}

/// The nearest points found so far: a heap with the farthest of them on top.
class NearestSet : public flann::ResultSet<double>
{
public:
  NearestSet(std::size_t most, double squaredRadius, std::vector<CloudNeighbor>& neighbors)
    : Most(most)
    , SquaredRadius(squaredRadius)
    , Neighbors(neighbors)
  {
    this->Neighbors.clear();
  }

  bool full() const override { return true; }

  void addPoint(double squaredDistance, std::size_t index) override
  {
    const CloudNeighbor neighbor{ static_cast<Id>(index), squaredDistance };
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
  }

  double worstDist() const override
  {
    const double farthest = this->Neighbors.size() < this->Most
      ? this->SquaredRadius
      : this->Neighbors.front().SquaredDistance;
    return WithHair(farthest);
  }

private:
  std::size_t Most;
  double SquaredRadius;
  std::vector<CloudNeighbor>& Neighbors;
};

/// Counts the points within a radius.
class Counter : public flann::ResultSet<double>
{
public:
  explicit Counter(double squaredRadius)
    : SquaredRadius(squaredRadius)
  {
  }

  std::size_t GetCount() const { return this->Count; }
  bool full() const override { return true; }
  void addPoint(double squaredDistance, std::size_t) override
  {
    this->Count += squaredDistance <= this->SquaredRadius ? 1 : 0;
  }
  double worstDist() const override { return WithHair(this->SquaredRadius); }

private:
  double SquaredRadius;
  std::size_t Count = 0;
};
}

class CloudNeighbors::Tree
{
public:
  explicit Tree(const std::vector<Point3>& points)
    : Points(points)
    , Index(flann::KDTreeSingleIndexParams(12, true))
  {
    // FLANN takes non-const data without changing it, and rejects empty data sets.
    if (!points.empty())
    {
      this->Index.buildIndex(
        flann::Matrix<double>(const_cast<double*>(&points[0].X), points.size(), 3));
    }
  }

  void Find(const Point3& place, std::size_t most, double squaredRadius,
    std::vector<CloudNeighbor>& neighbors) const
  {
    NearestSet set(most, squaredRadius, neighbors);
    if (!this->Points.empty() && most > 0)
    {
      this->Index.findNeighbors(set, &place.X, flann::SearchParams());
    }
    std::sort(neighbors.begin(), neighbors.end(), IsCloser);
  }

  std::size_t Count(const Point3& place, double squaredRadius) const
  {
    Counter counter(squaredRadius);
    if (!this->Points.empty())
    {
      this->Index.findNeighbors(counter, &place.X, flann::SearchParams());
    }
    return counter.GetCount();
  }

private:
  const std::vector<Point3>& Points;
  flann::KDTreeSingleIndex<Distance> Index;
};

CloudNeighbors::CloudNeighbors(const std::vector<Point3>& points)
  : Index(std::make_unique<Tree>(points))
{
}

CloudNeighbors::~CloudNeighbors() = default;

void CloudNeighbors::FindNearest(
  const Point3& place, std::size_t count, std::vector<CloudNeighbor>& neighbors) const
{
  this->Index->Find(place, count, std::numeric_limits<double>::max() / 4.0, neighbors);
}

void CloudNeighbors::FindWithin(
  const Point3& place, double radius, std::vector<CloudNeighbor>& neighbors) const
{
  this->Index->Find(place, std::numeric_limits<std::size_t>::max(), radius * radius, neighbors);
}

std::size_t CloudNeighbors::CountWithin(const Point3& place, double radius) const
{
  return this->Index->Count(place, radius * radius);
}
}
