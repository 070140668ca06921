// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Splits pieces of paths where they meet. Internal.
#ifndef dggPieceSplitter_h
#define dggPieceSplitter_h

#include "dggPathNodes.h"   // for PathNodes
#include "dggSegmentTree.h" // for segments that are close to others
#include "dggTypes.h"       // for ProgressCallback

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
  Status Split(Id face, const std::vector<std::size_t>& places, const ProgressCallback& progress);

private:
  /// A part of a piece.
  struct Segment
  {
    std::size_t Piece;
    std::size_t Start; // among the nodes of the piece
  };

  bool IsOnSide(Id a, Id b, Id face, int& side) const;
  Id FindNextOnSide(Id a, Id b, Id face, int side) const;
  void SplitAlongSides(PathPiece& piece, Id face) const;
  void CollectSegments(Id face, const std::vector<std::size_t>& places);
  bool SplitAtNodes(Id face, const ProgressCallback& progress, bool& found);
  Status SplitAtCrossings(Id face, const ProgressCallback& progress, bool& found);

  PathNodes& Nodes;
  std::vector<PathPiece>& Pieces;
  const bool InsertCrossings;
  std::vector<Segment> Segments;
  std::vector<GridSegment> Lines; // where the segments lie
  SegmentTree Tree;               // of the same
};
}

#endif
