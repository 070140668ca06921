// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points at the same position, or close to each other. Internal.
#ifndef dggCoincidentPoints_h
#define dggCoincidentPoints_h

#include "dggTypes.h" // for Id

#include <vector> // for ids

namespace dgg
{
/// Returns the representative of each of the points `ids`. Points are processed in this order: the
/// representative is the closest earlier point within the tolerance that represents itself, or the
/// point itself if there is none. For a tolerance of 0 it is the first point with the same
/// coordinates (-0 equals +0). `points` are x y z per point; the points `ids` are finite.
std::vector<Id> FindRepresentatives(
  const double* points, const std::vector<Id>& ids, double tolerance);
}

#endif
