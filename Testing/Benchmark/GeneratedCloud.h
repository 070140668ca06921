// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random points of surfaces on which distances are known.
#ifndef GeneratedCloud_h
#define GeneratedCloud_h

#include "dggTypes.h" // for Id

#include <functional> // for distances
#include <vector>     // for points

struct GeneratedCloud
{
  std::vector<double> Points; ///< x y z per point
  /// Distance between two points along the surface; Infinity where there is no way.
  std::function<double(dgg::Id, dgg::Id)> Distance;
};

/// Of the unit square.
GeneratedCloud RandomSquare(int count);

/// Of a cylinder of radius 1 and height 3.
GeneratedCloud RandomCylinder(int count);

/// Of the unit sphere, at its top so many times denser than at its bottom. `noise` is the deviation
/// of normal numbers that are added to each coordinate; distances are those between the nearest
/// points of the sphere.
GeneratedCloud RandomSphere(int count, double noise = 0.0, double density = 1.0);

/// Of two unit squares, one above the other by a gap; half of the points on each.
GeneratedCloud RandomSheets(int count, double gap);

#endif
