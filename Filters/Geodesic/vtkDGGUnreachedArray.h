// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What stands for "not reached" among distances, as an array in field data. Internal.
#ifndef vtkDGGUnreachedArray_h
#define vtkDGGUnreachedArray_h

#include "vtkType.h" // for vtkIdType

#include <string> // for the name
#include <vector> // for points

class vtkDataArray;
class vtkFieldData;

/// Distances of points that are not reached may be any number, the UnreachedValue of a distance
/// filter. NaN and plus infinity speak for themselves. Any other number could be a distance, so
/// that those who read the distances must be told: for distances named D by the field data array
/// `D.Unreached` (double), with the number, how many points there are, and the ids of points whose
/// distance just happens to be that number, as sources when it is 0. The ids count for as many
/// points only: those of fewer or more points may be those of others.
class vtkDGGUnreachedArray
{
public:
  /// Nothing is added where no one has to be told. `isReached` is per point.
  static void AddTo(vtkFieldData* data, vtkDataArray* distances, double unreachedValue,
    const std::vector<bool>& isReached);

  static void RemoveFrom(vtkFieldData* data, const std::string& distances);

  /// Remove those of all distances, whatever their names: arrays that look so and have the name of
  /// one of `points`, the point data. Others may be anything.
  static void RemoveAllFrom(vtkFieldData* data, vtkFieldData* points);

  /// Which points are not reached as the number `unreachedValue` stands for that, or, when it is
  /// NaN, that of the field data. Empty when none is by either. NaN and infinity among the
  /// distances are not looked at.
  static std::vector<bool> Find(vtkFieldData* data, vtkDataArray* distances, double unreachedValue);
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGUnreachedArray.h
