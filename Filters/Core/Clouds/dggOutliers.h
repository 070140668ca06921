// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of a cloud that are far from all others. Internal.
#ifndef dggOutliers_h
#define dggOutliers_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPoint3.h"     // for Point3
#include "dggTypes.h"      // for Id, Infinity

namespace dgg
{
/// Separates the few points that are far from the rest of a cloud, such as failed measurements or
/// placeholder values. Such points must not determine the extent or the center of the cloud,
/// because the remaining points would lose all their precision and voxel resolution.
///
/// Distances are measured from the center of the cloud, its median along each axis. Points are
/// outliers if each of them is more than `ratio` times as far as any other point, they occupy fewer
/// than 17 positions, and the others occupy at least 17. A spacing needs 16 neighbors, so that
/// points at 17 or more positions belong to the cloud, at any distance. Positions count, not
/// points. The distance between outliers is irrelevant: of the gaps that leave enough positions,
/// the nearest one separates the outliers.
class DGG_CORE_EXPORT Outliers
{
public:
  /// Default ratio, for graphs. A graph does not connect outliers, so that only unmistakable
  /// outliers may be excluded. Nearer points may be small objects; keeping them costs the cloud
  /// less than 10 bits of precision.
  static constexpr double LargestRatio = 1000.0;
  /// Ratio for searches and frames, which do not lose points: far points are processed
  /// individually, with the same results. A smaller ratio wastes less precision and fewer buckets.
  static constexpr double RatioOfFar = 4.0;

  /// Finds the outliers of `points` (x y z each). Ignores non-finite points.
  Outliers(const double* points, Id numberOfPoints, double ratio = LargestRatio);

  Id GetNumberOfPoints() const { return this->NumberOfPoints; }
  /// Returns true if a finite point is an outlier.
  bool IsOutlier(const Point3& point) const
  {
    return this->NumberOfPoints > 0 && this->QuarterDistance(point) > this->Limit;
  }

private:
  /// Returns a quarter of the distance from the center, because the full distance of large numbers
  /// may exceed the range of double.
  double QuarterDistance(const Point3& point) const;
  bool HasManyPlaces(const double* points, Id numberOfPoints) const;

  Id NumberOfPoints = 0;
  Point3 QuarterMiddle;
  double Limit = Infinity; ///< a quarter of the largest distance of a point that is not an outlier
};
}

#endif
