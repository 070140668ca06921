// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Identifies points on the boundaries of pieces of a surface. Internal.
#ifndef dggPieceRims_h
#define dggPieceRims_h

#include "dggDisjointSets.h"  // for the sets of points
#include "dggSurfacePieces.h" // for SurfacePiece

namespace dgg
{
/// Joins points that have the same position on the boundaries of different pieces, see
/// JoinSurfacePieces(). Ids in `points` count the points of all pieces in succession.
void JoinRims(const std::vector<SurfacePiece>& pieces, DisjointSets& points);
}

#endif
