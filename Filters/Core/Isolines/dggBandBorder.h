// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bands that continue in the pieces of other processes. Internal.
#ifndef dggBandBorder_h
#define dggBandBorder_h

#include "dggDistanceField.h" // for DistanceField
#include "dggPathEdges.h"     // for the lines

#include <array>      // for keys
#include <functional> // for offers
#include <map>        // for edges
#include <vector>     // for faces

namespace dgg
{
/// Edges of a refined surface at which faces of this process and of another one meet, as far as a
/// band may spread across the edge. All functions that return a Status must be called by all
/// processes, unless the field is not in pieces.
class BandBorder
{
public:
  /// Lines are the edges that bands do not cross.
  BandBorder(const DistanceField& field, const PathEdges& lines, FieldPieces* pieces)
    : Field(field)
    , Lines(lines)
    , Pieces(pieces)
  {
  }

  /// Finds the edges at which a face without a band touches another process. Without such edges on
  /// any process, the other functions exchange nothing.
  Status Connect(const std::vector<Id>& undecided);

  /// Sends the bands of the faces in `front`, which is sorted, and calls `offer(face, band)` for
  /// faces at the border with the bands of neighbors. A face that has sent its band is offered this
  /// band, too.
  Status Exchange(const std::vector<Id>& front, const std::vector<Id>& bandOf,
    const std::function<void(Id face, Id band)>& offer) const;

  /// Makes a condition false unless it is true on all processes.
  Status Require(bool& condition) const;

  /// Returns the faces that are the first ones of their components on the entire surface. `firstOf`
  /// has the first face of its component on this process for each face of `faces`, which is sorted.
  Status SelectFirst(
    const std::vector<Id>& faces, const std::vector<Id>& firstOf, std::vector<Id>& selected) const;

private:
  /// A part of an edge of the surface: global ids of the ends of the edge, and the parameter of the
  /// first end of the part, in units of the grid of refined faces.
  using EdgeKey = std::array<Offset, 3>;
  /// A face of the refined surface: global id of its cell, and index in the cell. The order is that
  /// of a single process.
  using FaceKey = std::array<Offset, 2>;

  bool IsOnBorder(Id h) const;
  EdgeKey MakeKey(Id h) const;
  FaceKey MakeFaceKey(Id face) const;

  const DistanceField& Field;
  const PathEdges& Lines;
  FieldPieces* const Pieces;       // may be null
  bool HasEdges = false;           // on any process
  std::map<EdgeKey, Id> HalfEdges; // of this process at the border
};
}

#endif
