// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What waves of several sources do between two points, and between three. Internal.
#ifndef dggLevelTurns_h
#define dggLevelTurns_h

#include "dggLevelArc.h" // for LevelPoint

#include <array>  // for three points
#include <vector> // for the points

namespace dgg
{
/// A place that is looked at, and on which side of the level it counts.
struct LevelEnd
{
  const LevelPoint& Point;
  bool IsAbove;
};

/// Append points of the straight line between two others, in order, so that the level is crossed
/// once at most between any two neighbours: where waves are lowest and where they meet. Nothing is
/// appended when the ends suffice.
void FindTurns(const LevelArc& arc, double level, const LevelEnd& from, const LevelEnd& to,
  std::vector<LevelPoint>& turns);

/// Where the waves of three points meet, if that is inside their triangle: the field may be higher
/// there than all around.
bool FindMeeting(const std::array<const LevelPoint*, 3>& points, Point2& meeting);
}

#endif
