// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Minima and ties of the wavefronts of several sources between two points. Internal.
#ifndef dggLevelTurns_h
#define dggLevelTurns_h

#include "dggLevelArc.h" // for LevelPoint

#include <vector> // for the points

namespace dgg
{
/// A sampled point, and the side of the level on which it counts.
struct LevelEnd
{
  const LevelPoint& Point;
  bool IsAbove;
};

/// Appends points on the straight line between two points, in order, so that the level is crossed
/// at most once between neighbors. The points are the minima and the ties of wavefronts; between
/// points without images, one point on the ridge. No point is appended if the ends suffice.
void FindTurns(const LevelArc& arc, double level, const LevelEnd& from, const LevelEnd& to,
  std::vector<LevelPoint>& turns);
}

#endif
