// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Minima and ties of the wavefronts of several sources between two points, and between three.
/// Internal.
#ifndef dggLevelTurns_h
#define dggLevelTurns_h

#include "dggLevelArc.h" // for LevelPoint

#include <array>  // for three points
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

/// Finds the point at which the wavefronts of three samples meet, which may be a local maximum.
/// Returns false if the point does not lie inside the triangle of the samples.
bool FindMeeting(const std::array<const LevelPoint*, 3>& points, Point2& meeting);
}

#endif
