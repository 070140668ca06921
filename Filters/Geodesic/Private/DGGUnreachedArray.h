// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point array that marks unreached points of a distance array. Internal.
#ifndef DGGUnreachedArray_h
#define DGGUnreachedArray_h

#include <string> // for the name
#include <vector> // for points

class vtkDataArray;
class vtkPointData;

/// Marks unreached points. Their distance may be any number, the UnreachedValue of a distance
/// filter. NaN and plus infinity are unambiguous; any other number could be a distance. Therefore,
/// for distances named D, the point array `D.Unreached` (unsigned char) is 1 at unreached points
/// and 0 elsewhere.
class DGGUnreachedArray
{
public:
  /// Adds the array unless all points are reached or the value is NaN or infinity. `isReached` is
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
