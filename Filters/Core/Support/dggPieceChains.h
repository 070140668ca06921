// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From pieces of curves to curves. Internal.
#ifndef dggPieceChains_h
#define dggPieceChains_h

#include "dggTypes.h" // for Id

#include <array>   // for the ends of pieces
#include <cstddef> // for std::size_t
#include <vector>  // for the chains

namespace dgg
{
/// A piece as a chain runs through it.
struct PiecePassage
{
  std::size_t Piece;
  bool IsBackward;
};

/// Pieces of which each ends where the next one begins.
struct PieceChain
{
  std::vector<PiecePassage> Passages;
  bool IsClosed = false;
};

/// Join pieces, given by the points that they begin and end in, wherever two of their ends meet,
/// and no more. Chains that begin where fewer or more meet come first, then closed ones; those of
/// each kind by the points that they begin in, then by their first pieces. Each piece is in one
/// chain.
std::vector<PieceChain> JoinPieces(const std::vector<std::array<Id, 2>>& pieces);
}

#endif
