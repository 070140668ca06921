// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Splits pieces of paths where they meet. Internal.
#ifndef dggPieceSplitter_h
#define dggPieceSplitter_h

#include "dggPathNodes.h" // for PathNodes

#include <cstddef> // for std::size_t
#include <vector>  // for pieces

namespace dgg
{
/// A straight piece of a path within one face.
struct PathPiece
{
  Id Path = NoId;
  std::vector<Id> Nodes;  ///< its ends, and between them what it passes
  std::size_t Number = 0; ///< among the pieces of the path
};

/// Split the pieces in a face, those at `places`, at nodes that they pass and where they cross each
/// other, which adds nodes. Fails when they cross and crossings are not to be inserted.
Status SplitPieces(PathNodes& nodes, std::vector<PathPiece>& pieces, bool insertCrossings, Id face,
  const std::vector<std::size_t>& places, const ProgressCallback& progress);
}

#endif
