// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voxel traversal along a segment.
#ifndef dggSegmentWalk_h
#define dggSegmentWalk_h

#include "dggPoint3.h" // for Point3
#include "dggTypes.h"  // for Infinity

#include <array>   // for cells
#include <cmath>   // for std::floor
#include <cstdint> // for cells

namespace dgg
{
/// Calls `visit(x, y, z)` for the unit cells that a segment crosses, from start to end, one step
/// along one axis at a time (Amanatides and Woo 1987). Stops and returns false if `visit` returns
/// false. If the segment passes through a corner or an edge of cells, one of the adjacent cells is
/// visited in between. Coordinates must fit into 32-bit integers.
template <typename Visitor>
bool WalkSegment(const Point3& from, const Point3& to, Visitor&& visit)
{
  const std::array<double, 3> start{ from.X, from.Y, from.Z };
  const std::array<double, 3> end{ to.X, to.Y, to.Z };
  std::array<std::int32_t, 3> cell;
  std::array<std::int32_t, 3> step;
  std::array<double, 3> next;  // segment parameter of the next cell boundary along each axis
  std::array<double, 3> delta; // parameter increment between two boundaries
  std::array<std::int64_t, 3> steps;
  for (int k = 0; k < 3; ++k)
  {
    cell[k] = static_cast<std::int32_t>(std::floor(start[k]));
    const auto last = static_cast<std::int32_t>(std::floor(end[k]));
    const double length = end[k] - start[k];
    step[k] = last > cell[k] ? 1 : -1;
    steps[k] = std::abs(static_cast<std::int64_t>(last) - cell[k]);
    if (steps[k] == 0)
    {
      next[k] = delta[k] = Infinity;
      continue;
    }
    delta[k] = 1.0 / std::abs(length);
    next[k] = delta[k] * (step[k] > 0 ? cell[k] + 1 - start[k] : start[k] - cell[k]);
  }
  // The number of steps along each axis is computed in advance, so that rounding cannot lead past
  // the end.
  for (std::int64_t left = steps[0] + steps[1] + steps[2]; left > 0; --left)
  {
    if (!visit(cell[0], cell[1], cell[2]))
    {
      return false;
    }
    const int axis =
      next[0] <= next[1] ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
    cell[axis] += step[axis];
    next[axis] = --steps[axis] > 0 ? next[axis] + delta[axis] : Infinity;
  }
  return visit(cell[0], cell[1], cell[2]);
}
}

#endif
