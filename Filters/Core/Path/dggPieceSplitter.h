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
  std::vector<Id> Nodes; ///< its ends, and between them what it passes
};

/// Splits the pieces in a face at nodes that they pass and where they cross each other, which adds
/// nodes.
class PieceSplitter
{
public:
  PieceSplitter(PathNodes& nodes, std::vector<PathPiece>& pieces, bool insertCrossings)
    : Nodes(nodes)
    , Pieces(pieces)
    , InsertCrossings(insertCrossings)
  {
  }

  /// `places` are those of the pieces in the face. Fails when they cross and crossings are not to
  /// be inserted.
  Status Split(Id face, const std::vector<std::size_t>& places);

private:
  bool SplitAtNodes(PathPiece& piece, Id face) const;
  Id FindNextOnSide(Id a, Id b, Id face, int side) const;
  Status SplitAtCrossings(Id face, const std::vector<std::size_t>& places, bool& found);

  PathNodes& Nodes;
  std::vector<PathPiece>& Pieces;
  const bool InsertCrossings;
};
}

#endif
