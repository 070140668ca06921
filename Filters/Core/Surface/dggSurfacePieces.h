// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Pieces of a surface, and the numbering of the surface that they form. Internal.
#ifndef dggSurfacePieces_h
#define dggSurfacePieces_h

#include "dggCellArrays.h" // for CellArrays
#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggStatus.h"     // for Status

#include <array>   // for the kinds of cells
#include <cstddef> // for std::size_t
#include <vector>  // for the numbers

namespace dgg
{
/// Kinds of cells, in the order of their ids: vertices, lines, polygons, strips.
constexpr int NumberOfCellKinds = 4;

/// Points and cells of a piece: a block, a partition, or the part that one of several processes
/// holds.
struct DGG_CORE_EXPORT SurfacePiece
{
  int Block = 0;                  ///< pieces of different blocks are not connected
  const double* Points = nullptr; ///< x y z each
  Offset NumberOfPoints = 0;
  bool AreFromFloats = false; ///< the points were stored in single precision
  std::array<CellArrays, NumberOfCellKinds> Cells;
  ///@{
  /// Global ids; null if there are none.
  const Offset* PointIds = nullptr;
  const Offset* CellIds = nullptr;
  ///@}
  ///@{
  /// Flags; bit 0 is set if another process owns the point or cell. Null if there are none.
  const unsigned char* PointFlags = nullptr;
  const unsigned char* CellFlags = nullptr;
  ///@}

  Offset GetNumberOfCells() const;
  /// Returns an error if a cell has a point id that is out of range.
  Status Check() const;
};

/// Point or cell of a piece.
struct PieceElement
{
  std::size_t Piece = 0;
  Offset Index = -1;
};

/// Ids of the points and cells of a piece on a surface; -1 for points and cells that are not on the
/// surface.
struct DGG_CORE_EXPORT PieceIds
{
  std::vector<Offset> Points;
  std::vector<Offset> Cells;

  /// Returns the ids of a piece that is the entire surface: they are unchanged.
  static PieceIds MakeIdentity(Offset numberOfPoints, Offset numberOfCells);
};

/// Points and cells of a surface that is assembled from pieces.
struct PieceNumbering
{
  std::vector<PieceIds> Pieces;

  ///@{
  /// For each point and cell of the surface, the first of the elements that have its id.
  std::vector<PieceElement> Points;
  std::vector<PieceElement> Cells;
  ///@}
  std::array<Offset, NumberOfCellKinds + 1> FirstCells{}; ///< of each kind, on the surface
};

/// Joins pieces, sorted by blocks, to one surface. Points of one block are identified
///  - if all pieces have global ids: by equal ids, which must not occur at other positions;
///  - otherwise by equal positions on the boundaries of different pieces. If a piece has several
///    points at one position, at a seam, only ends of edges that coincide are identified.
/// Points are numbered block by block, within a block by global ids or else piece by piece in their
/// order. Cells are numbered in the same manner within their kind; cells with the same global id on
/// the same points are identified.
DGG_CORE_EXPORT Status JoinSurfacePieces(
  const std::vector<SurfacePiece>& pieces, PieceNumbering& numbering);

/// Returns true if another process owns one of `size` points or cells. `flags` may be null.
DGG_CORE_EXPORT bool HasGhosts(const unsigned char* flags, Offset size);

/// Excludes the cells of a piece that another process owns, and points that only these cells use.
/// Positions are not used.
DGG_CORE_EXPORT Status ExcludeGhosts(const SurfacePiece& piece, PieceNumbering& numbering);
}

#endif
