// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of a cloud that are far off all others. Internal.
#ifndef dggStrayPoints_h
#define dggStrayPoints_h

#include "dggPoint3.h" // for Point3
#include "dggTypes.h"  // for Id, Infinity

namespace dgg
{
/// Tells the few points that are far off a cloud from the rest, as readings gone wrong are, or
/// numbers that stand for no reading. Such points must not decide how large the cloud is, nor where
/// its middle is: nothing would be left of its digits, or of its voxels.
///
/// Distances are the largest of those along the axes, from the middle of the cloud, its median
/// along each axis. Points are stray when they are more than four times as far as any of the
/// others, and in fewer than 17 places: a spacing needs 16 neighbours, so that more than these are
/// a part of the cloud, however far. The rest has to be in 17 places at least.
class StrayPoints
{
public:
  /// `points` are x y z per point. Those that are not finite do not count.
  StrayPoints(const double* points, Id numberOfPoints);

  Id GetNumberOfPoints() const { return this->NumberOfPoints; }
  /// Of a point that is finite.
  bool IsStray(const Point3& point) const
  {
    return this->NumberOfPoints > 0 && this->HalfDistance(point) > this->Limit;
  }

private:
  /// From the middle. Half of it: that of large numbers may be beyond the range of double.
  double HalfDistance(const Point3& point) const;
  bool HasManyPlaces(const double* points, Id numberOfPoints) const;

  Id NumberOfPoints = 0;
  Point3 HalfMiddle;
  double Limit = Infinity; ///< half the distance of the farthest of the others
};
}

#endif
