// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Identifies points on the boundaries of pieces of a surface. Internal.
#ifndef dggPieceRims_h
#define dggPieceRims_h

#include "dggDisjointSets.h" // for the sets of points
#include "dggPieces.h"       // for Piece

namespace dgg
{
/// Joins points that have the same position on the boundaries of different pieces, see
/// JoinPieces(). Ids in `points` count the points of all pieces in succession.
void JoinRims(const std::vector<Piece>& pieces, DisjointSets& points);
}

#endif
