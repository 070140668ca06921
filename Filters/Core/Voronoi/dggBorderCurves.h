// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From pieces of the borders of Voronoi cells to curves. Internal.
#ifndef dggBorderCurves_h
#define dggBorderCurves_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <array>  // for pairs
#include <vector> // for the pieces

namespace dgg
{
struct VoronoiDiagram;

/// A piece of an edge of the mesh along a cell that does not own it: what belongs to a cell on one
/// side of the edge only.
struct BorderSide
{
  std::array<Id, 2> Points; ///< the smaller one first
  Id Site;                  ///< of the cell
  Id Owner;                 ///< of that piece of the edge
  Id HalfEdge;
};

/// Collects the pieces of borders, and joins those between the same two cells to curves.
class BorderCurves
{
public:
  /// A piece between two cells, unless they are the same.
  void AddPiece(Id site, Id other, const std::array<Id, 2>& points);
  void AddSide(const BorderSide& side) { this->Sides.push_back(side); }

  /// Append curves, as long as they are, to a diagram. A curve ends where another cell is met, at
  /// the boundary of the surface, or where borders branch, which they do on edges with more than
  /// two faces. The result does not depend on the order of the pieces.
  void AddTo(const SurfaceMesh& mesh, VoronoiDiagram& diagram);

private:
  using Side = std::vector<BorderSide>::const_iterator;
  void AddPiecesOfSide(const SurfaceMesh& mesh, Side begin, Side end);

  /// Between the smaller site and the other one.
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
