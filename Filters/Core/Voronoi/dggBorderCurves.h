// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Joins border segments of Voronoi cells into curves. Internal.
#ifndef dggBorderCurves_h
#define dggBorderCurves_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <array>  // for pairs
#include <vector> // for the pieces

namespace dgg
{
struct VoronoiDiagram;

/// A segment of a mesh edge along a cell that does not own the segment: a border along the edge.
struct BorderSide
{
  std::array<Id, 2> Points; ///< in ascending order
  Id Site;                  ///< site of the cell
  Id Owner;                 ///< site that owns the segment
  Id HalfEdge;
};

/// Collects border segments, and joins those between the same two cells into curves.
class BorderCurves
{
public:
  /// Adds a segment between two cells; ignored if both are the same.
  void AddPiece(Id site, Id other, const std::array<Id, 2>& points);
  void AddSide(const BorderSide& side) { this->Sides.push_back(side); }

  /// Appends maximal curves to a diagram. A curve ends where another cell is adjacent, at the
  /// boundary of the surface, or where borders branch, which they do on non-manifold edges. The
  /// result does not depend on the order of the segments.
  void AddTo(const SurfaceMesh& mesh, VoronoiDiagram& diagram);

private:
  using Side = std::vector<BorderSide>::const_iterator;
  void AddPiecesOfSide(const SurfaceMesh& mesh, Side begin, Side end);

  /// A segment between two sites, in ascending order.
  struct Piece
  {
    std::array<Id, 2> Sites;
    std::array<Id, 2> Points;
  };
  std::vector<Piece> Pieces;
  std::vector<BorderSide> Sides;
};
}

#endif
