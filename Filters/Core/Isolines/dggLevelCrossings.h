// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where levels of a distance cross the edges of a mesh. Internal.
#ifndef dggLevelCrossings_h
#define dggLevelCrossings_h

#include "dggDistanceField.h" // for DistanceField
#include "dggIsolineParts.h"  // for LevelCrossing
#include "dggParallel.h"      // for ParallelFor

#include <vector> // for the crossings

namespace dgg
{
/// All crossings of all edges of faces that are reached.
struct LevelCrossings
{
  /// In order of half-edges, then levels, then abscissae.
  std::vector<LevelCrossing> Crossings;
  /// Those of half-edge h, if it stands for its edge: [Offsets[h], Offsets[h + 1]).
  std::vector<Id> Offsets;
};

/// `levels` increase.
Status FindLevelCrossings(const DistanceField& field, const std::vector<double>& levels,
  const ParallelFor& parallel, const ProgressCallback& progress, LevelCrossings& found);
}

#endif
