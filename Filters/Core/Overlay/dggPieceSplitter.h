// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Splits path segments at their intersections. Internal.
#ifndef dggPieceSplitter_h
#define dggPieceSplitter_h

#include "dggPathNodes.h" // for PathNodes

#include <cstddef> // for std::size_t
#include <vector>  // for pieces

namespace dgg
{
/// A straight segment of a path within one face.
struct PathPiece
{
  Id Path = NoId;
  std::vector<Id> Nodes;  ///< its ends, and the nodes on it in between
  std::size_t Number = 0; ///< index among the segments of the path
};

/// Splits segments in a face at nodes on them and at crossings, which adds nodes. `places` are the
/// indices of the segments. Fails if segments cross and crossings must not be inserted.
Status SplitPieces(PathNodes& nodes, std::vector<PathPiece>& pieces, bool insertCrossings, Id face,
  const std::vector<std::size_t>& places, const ProgressCallback& progress);
}

#endif
