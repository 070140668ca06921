// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Joins segments of curves into chains. Internal.
#ifndef dggPieceChains_h
#define dggPieceChains_h

#include "dggTypes.h" // for Id

#include <array>   // for the ends of pieces
#include <cstddef> // for std::size_t
#include <vector>  // for the chains

namespace dgg
{
/// A segment with its direction in a chain.
struct PiecePassage
{
  std::size_t Piece;
  bool IsBackward;
};

/// Consecutive segments of a chain.
struct PieceChain
{
  std::vector<PiecePassage> Passages;
  bool IsClosed = false;
};

/// Joins segments, given by their start and end points, at all points where exactly two segment
/// ends meet. Open chains come first, then closed ones; each group is sorted by start point, then
/// by first segment. Each segment belongs to exactly one chain.
std::vector<PieceChain> JoinPieces(const std::vector<std::array<Id, 2>>& pieces);
}

#endif
