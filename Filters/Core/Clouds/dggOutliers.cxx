// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggOutliers.h"

#include "dggCloudFrame.h"
#include "dggQuantile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace dgg
{
namespace
{
constexpr std::size_t MostPlaces = 16;

/// A small set of distinct positions.
class Places
{
public:
  /// Adds a position. Returns false if the maximum number is exceeded.
  bool Add(const Point3& p)
  {
    const auto isHere = [&](const Point3& q) { return p.X == q.X && p.Y == q.Y && p.Z == q.Z; };
    if (std::any_of(this->Known.begin(), this->Known.end(), isHere))
    {
      return true;
    }
    this->Known.push_back(p);
    return this->Known.size() <= MostPlaces;
  }

private:
  std::vector<Point3> Known;
};

template <typename Visitor>
void ForEachFinite(const double* points, Id numberOfPoints, Visitor&& visit)
{
  for (Id i = 0; i < numberOfPoints; ++i)
  {
    const Point3 p = PointAt(points, i);
    if (IsFinite(p))
    {
      visit(p);
    }
  }
}

struct FarPoint
{
  double QuarterDistance;
  Point3 Place;
};
}

Outliers::Outliers(const double* points, Id numberOfPoints, double ratio)
{
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(numberOfPoints));
  for (double Point3::*const axis : { &Point3::X, &Point3::Y, &Point3::Z })
  {
    values.clear();
    ForEachFinite(points, numberOfPoints, [&](const Point3& p) { values.push_back(p.*axis); });
    if (values.size() <= MostPlaces + 1)
    {
      return;
    }
    this->QuarterMiddle.*axis = 0.25 * Quantile(values, 0.5);
  }
  values.clear();
  ForEachFinite(
    points, numberOfPoints, [&](const Point3& p) { values.push_back(this->QuarterDistance(p)); });
  const double median = Quantile(values, 0.5);

  // The median distance separates outliers by the ratio, since at least half of the points are at
  // most at the median distance.
  std::vector<FarPoint> far;
  double inner = 0.0;
  ForEachFinite(points, numberOfPoints, [&](const Point3& p) {
    const double distance = this->QuarterDistance(p);
    if (distance / ratio > median)
    {
      far.push_back({ distance, p });
    }
    else
    {
      inner = std::max(inner, distance);
    }
  });
  std::sort(far.begin(), far.end(),
    [](const FarPoint& a, const FarPoint& b) { return a.QuarterDistance > b.QuarterDistance; });
  Places places;
  std::vector<std::size_t> gaps; // number of points beyond each gap
  for (std::size_t i = 0; i < far.size() && places.Add(far[i].Place); ++i)
  {
    const double next = i + 1 < far.size() ? far[i + 1].QuarterDistance : inner;
    if (next > 0.0 && far[i].QuarterDistance / ratio > next)
    {
      gaps.push_back(i + 1);
    }
  }
  // Choose the nearest gap that leaves enough points.
  for (auto gap = gaps.rbegin(); gap != gaps.rend(); ++gap)
  {
    this->NumberOfPoints = static_cast<Id>(*gap);
    this->Limit = *gap < far.size() ? far[*gap].QuarterDistance : inner;
    if (this->HasManyPlaces(points, numberOfPoints))
    {
      return;
    }
  }
  this->NumberOfPoints = 0;
}

/// Returns true if the points other than outliers occupy enough positions.
bool Outliers::HasManyPlaces(const double* points, Id numberOfPoints) const
{
  Places places;
  for (Id i = 0; i < numberOfPoints; ++i)
  {
    const Point3 p = PointAt(points, i);
    if (IsFinite(p) && !this->IsOutlier(p) && !places.Add(p))
    {
      return true;
    }
  }
  return false;
}

double Outliers::QuarterDistance(const Point3& point) const
{
  const Point3& middle = this->QuarterMiddle;
  return std::hypot(
    0.25 * point.X - middle.X, 0.25 * point.Y - middle.Y, 0.25 * point.Z - middle.Z);
}
}
