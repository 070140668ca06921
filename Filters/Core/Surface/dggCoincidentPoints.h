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
/// Returns for each of the points `ids` the one that represents it: in their order, the closest one
/// within the tolerance among those before it that represent themselves, else itself. For a
/// tolerance of 0, the first one with the same coordinates (-0 equals +0). `points` are x y z per
/// point, finite for these ids.
std::vector<Id> FindRepresentatives(
  const double* points, const std::vector<Id>& ids, double tolerance);
}

#endif
