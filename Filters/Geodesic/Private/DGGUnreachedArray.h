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
class vtkPolyData;

/// Removes the arrays that belong to distances from a surface: marks of unreached points
/// (dgg::AddDistances()) and windows (DGGWindowArrays).
void DGGRemoveDistances(vtkPolyData* surface, const std::string& distances);

/// Returns, per point, true if it is not reached: if its distance is `unreachedValue` or, when
/// `unreachedValue` is NaN, if an array marks it. Empty if `unreachedValue` is NaN and there is no
/// such array. NaN and infinity among the distances are not interpreted.
std::vector<bool> DGGFindUnreached(
  vtkPointData* data, vtkDataArray* distances, double unreachedValue);

#endif
