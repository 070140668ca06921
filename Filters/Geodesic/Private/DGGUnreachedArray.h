// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which points are not reached, as a point array beside their distances. Internal.
#ifndef DGGUnreachedArray_h
#define DGGUnreachedArray_h

#include <string> // for the name
#include <vector> // for points

class vtkDataArray;
class vtkPointData;

/// Distances of points that are not reached may be any number, the UnreachedValue of a distance
/// filter. NaN and plus infinity speak for themselves. Any other number could be a distance, so
/// that for distances named D the point array `D.Unreached` (unsigned char) is 1 where a point is
/// not reached, else 0.
class DGGUnreachedArray
{
public:
  /// Nothing is added where all points are reached or the value speaks for itself. `isReached` is
  /// per point.
  static void AddTo(vtkPointData* data, const std::string& distances, double unreachedValue,
    const std::vector<bool>& isReached);

  static void RemoveFrom(vtkPointData* data, const std::string& distances);

  /// Returns, per point, true if it is not reached: if its distance is `unreachedValue` or, when
  /// `unreachedValue` is NaN, if the array `D.Unreached` marks it. Empty if `unreachedValue` is NaN
  /// and there is no such array. NaN and infinity among the distances are not interpreted.
  static std::vector<bool> Find(vtkPointData* data, vtkDataArray* distances, double unreachedValue);
};

#endif
