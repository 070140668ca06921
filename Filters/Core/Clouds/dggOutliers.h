// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of a cloud that are far off all others. Internal.
#ifndef dggOutliers_h
#define dggOutliers_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPoint3.h"     // for Point3
#include "dggTypes.h"      // for Id, Infinity

namespace dgg
{
/// Separates the few points that are far off a cloud from the rest, as readings gone wrong are, or
/// numbers that mean no reading. Such points must not decide how large the cloud is, nor where
/// its middle is: nothing would be left of its digits, or of its voxels.
///
/// Distances are from the middle of the cloud, its median along each axis. Points are outliers when
/// each of them is more than `ratio` times as far as any of the others, when they are in fewer than
/// 17 places, and the others in 17 places at least: a spacing needs 16 neighbours, so that more
/// places are a part of the cloud, however far. Places count, not points. Outliers may be as
/// far from each other as from the cloud: it is the nearest gap that counts, of those that leave
/// enough places.
class DGG_CORE_EXPORT Outliers
{
public:
  /// One rule, with a ratio for each of two ends. For graphs: outliers are connected to
  /// nothing, so that they must be beyond doubt. Nearer ones may be objects of few points, and cost
  /// a cloud less than 10 bits of its digits.
  static constexpr double LargestRatio = 1000.0;
  /// For searches and frames, which lose no point: those outside are looked at one by one, and the
  /// answers are the same. The smaller the ratio, the fewer digits and buckets are lost to them.
  static constexpr double RatioOfFar = 4.0;

  /// `points` are x y z per point. Those that are not finite do not count.
  Outliers(const double* points, Id numberOfPoints, double ratio = LargestRatio);

  Id GetNumberOfPoints() const { return this->NumberOfPoints; }
  /// Of a point that is finite.
  bool IsOutlier(const Point3& point) const
  {
    return this->NumberOfPoints > 0 && this->QuarterDistance(point) > this->Limit;
  }

private:
  /// From the middle. A quarter of it: that of large numbers may be beyond the range of double.
  double QuarterDistance(const Point3& point) const;
  bool HasManyPlaces(const double* points, Id numberOfPoints) const;

  Id NumberOfPoints = 0;
  Point3 QuarterMiddle;
  double Limit = Infinity; ///< a quarter of the distance of the farthest of the others
};
}

#endif
