// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggStrayPoints.h"

#include "dggCloudFrame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace dgg
{
namespace
{
constexpr std::size_t MostPlaces = 16;
constexpr double LargestRatio = 4.0;

/// Distinct places, a few of them.
class Places
{
public:
  /// False when there would be more than the most.
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

double Median(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct FarPoint
{
  double HalfDistance;
  Point3 Place;
};
}

StrayPoints::StrayPoints(const double* points, Id numberOfPoints)
{
  std::vector<double> values;
  for (double Point3::*const axis : { &Point3::X, &Point3::Y, &Point3::Z })
  {
    values.clear();
    ForEachFinite(points, numberOfPoints, [&](const Point3& p) { values.push_back(p.*axis); });
    if (values.size() <= MostPlaces + 1)
    {
      return;
    }
    this->HalfMiddle.*axis = 0.5 * Median(values);
  }
  values.clear();
  ForEachFinite(
    points, numberOfPoints, [&](const Point3& p) { values.push_back(this->HalfDistance(p)); });
  const double median = Median(values);

  // At least half of the points are not farther than the median, so stray ones are by that much.
  std::vector<FarPoint> far;
  double inner = 0.0;
  ForEachFinite(points, numberOfPoints, [&](const Point3& p) {
    const double distance = this->HalfDistance(p);
    if (distance / LargestRatio > median)
    {
      far.push_back({ distance, p });
    }
    else
    {
      inner = std::max(inner, distance);
    }
  });
  std::sort(far.begin(), far.end(),
    [](const FarPoint& a, const FarPoint& b) { return a.HalfDistance > b.HalfDistance; });
  Places places;
  for (std::size_t i = 0; i < far.size() && places.Add(far[i].Place); ++i)
  {
    const double next = i + 1 < far.size() ? far[i + 1].HalfDistance : inner;
    if (next > 0.0 && far[i].HalfDistance / LargestRatio > next)
    {
      this->NumberOfPoints = static_cast<Id>(i + 1);
      this->Limit = next;
    }
  }
  if (this->NumberOfPoints > 0 && !this->HasManyPlaces(points, numberOfPoints))
  {
    this->NumberOfPoints = 0;
  }
}

/// Whether the points that are not stray are enough to be a cloud.
bool StrayPoints::HasManyPlaces(const double* points, Id numberOfPoints) const
{
  Places places;
  for (Id i = 0; i < numberOfPoints; ++i)
  {
    const Point3 p = PointAt(points, i);
    if (IsFinite(p) && !this->IsStray(p) && !places.Add(p))
    {
      return true;
    }
  }
  return false;
}

double StrayPoints::HalfDistance(const Point3& point) const
{
  return std::max({ std::abs(0.5 * point.X - this->HalfMiddle.X),
    std::abs(0.5 * point.Y - this->HalfMiddle.Y), std::abs(0.5 * point.Z - this->HalfMiddle.Z) });
}
}
