// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfacePieces.h"

#include "dggBoxTree.h"
#include "dggDisjointSets.h"
#include "dggPieceRims.h"
#include "dggPoint3.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace dgg
{
namespace
{
/// Largest distance between points with the same global id, as a fraction of the diagonal:
/// processes may round coordinates differently.
constexpr double IdTolerance = 1e-5;

/// Point or cell of a piece, sorted by blocks and, within a block, by global ids.
struct GlobalElement
{
  int Block;
  Offset GlobalId; // 0 if there are none
  PieceElement Element;

  bool HasSameId(const GlobalElement& other) const
  {
    return this->Block == other.Block && this->GlobalId == other.GlobalId;
  }
  bool operator<(const GlobalElement& other) const
  {
    return std::tie(this->Block, this->GlobalId, this->Element.Piece, this->Element.Index) <
      std::tie(other.Block, other.GlobalId, other.Element.Piece, other.Element.Index);
  }
};

Point3 GetPosition(const std::vector<SurfacePiece>& pieces, const PieceElement& point)
{
  return PointAt(pieces[point.Piece].Points, static_cast<Id>(point.Index));
}

/// Joins points of one block that have equal global ids. `first` is the id of the first point of
/// each piece in `points`. Fails if such points have different positions, which happens if each
/// process has numbered its own points.
Status JoinGlobalIds(
  const std::vector<SurfacePiece>& pieces, const std::vector<Id>& first, DisjointSets& points)
{
  std::vector<GlobalElement> elements;
  Box box;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (Offset i = 0; i < pieces[p].NumberOfPoints; ++i)
    {
      elements.push_back({ pieces[p].Block, pieces[p].PointIds[i], { p, i } });
      box.Add(pieces[p].Points + 3 * i);
    }
  }
  std::sort(elements.begin(), elements.end());
  for (std::size_t k = 1; k < elements.size(); ++k)
  {
    const PieceElement& one = elements[k - 1].Element;
    const PieceElement& other = elements[k].Element;
    if (!elements[k].HasSameId(elements[k - 1]))
    {
      continue;
    }
    points.Join(first[one.Piece] + static_cast<Id>(one.Index),
      first[other.Piece] + static_cast<Id>(other.Index));
    const Point3 a = GetPosition(pieces, one);
    const Point3 b = GetPosition(pieces, other);
    if (IsFinite(a) != IsFinite(b) ||
      std::hypot(a.X - b.X, a.Y - b.Y, a.Z - b.Z) > IdTolerance * box.GetDiagonal())
    {
      return InvalidInput("Two points have the global id ", elements[k].GlobalId, ", one at (", a.X,
        ", ", a.Y, ", ", a.Z, ") and one at (", b.X, ", ", b.Y, ", ", b.Z, ")")
        .Fix("Renumber the points of all pieces, or remove the global ids to join the pieces by "
             "coordinates");
    }
  }
  return Status::Success();
}

/// Numbers the sets of joined points consecutively: block by block, within a block by global ids if
/// they exist.
void NumberPoints(const std::vector<SurfacePiece>& pieces, const std::vector<Id>& first,
  bool haveIds, DisjointSets& points, PieceNumbering& numbering)
{
  std::vector<GlobalElement> order; // one point of each set
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (Offset i = 0; i < pieces[p].NumberOfPoints; ++i)
    {
      const Id idInAll = first[p] + static_cast<Id>(i);
      if (points.Find(idInAll) == idInAll)
      {
        order.push_back({ pieces[p].Block, haveIds ? pieces[p].PointIds[i] : 0, { p, i } });
      }
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<Offset> ofSets(static_cast<std::size_t>(first.back()), -1);
  for (const GlobalElement& point : order)
  {
    ofSets[first[point.Element.Piece] + point.Element.Index] =
      static_cast<Offset>(numbering.Points.size());
    numbering.Points.push_back(point.Element);
  }
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (Id i = first[p]; i < first[p + 1]; ++i)
    {
      numbering.Pieces[p].Points.push_back(ofSets[points.Find(i)]);
    }
  }
}

/// Returns the ids on the surface of the points of cell `i` of `cells`, sorted.
std::vector<Offset> GetCorners(const CellArrays& cells, Offset i, const std::vector<Offset>& points)
{
  std::vector<Offset> corners;
  std::transform(cells.Begin(i), cells.End(i), std::back_inserter(corners),
    [&](Offset point) { return points[point]; });
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Numbers the cells of one kind. Cells with the same global id are joined if they have the same
/// points; otherwise they are not, because faces of a volume have the id of the volume.
void NumberCells(
  const std::vector<SurfacePiece>& pieces, int kind, bool haveIds, PieceNumbering& numbering)
{
  std::vector<Offset> first; // id of the first cell of this kind, per piece
  std::vector<GlobalElement> order;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    std::vector<Offset>& cells = numbering.Pieces[p].Cells;
    first.push_back(static_cast<Offset>(cells.size()));
    cells.resize(cells.size() + pieces[p].Cells[kind].NumberOfCells, -1);
    for (auto i = first.back(); i < static_cast<Offset>(cells.size()); ++i)
    {
      order.push_back({ pieces[p].Block, haveIds ? pieces[p].CellIds[i] : 0, { p, i } });
    }
  }
  const auto getCorners = [&](const PieceElement& cell) {
    return GetCorners(pieces[cell.Piece].Cells[kind], cell.Index - first[cell.Piece],
      numbering.Pieces[cell.Piece].Points);
  };
  std::sort(order.begin(), order.end(), [&](const GlobalElement& a, const GlobalElement& b) {
    return haveIds && a.HasSameId(b)
      ? std::make_pair(getCorners(a.Element), a) < std::make_pair(getCorners(b.Element), b)
      : a < b;
  });
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    const PieceElement& cell = order[k].Element;
    const bool isAgain = haveIds && k > 0 && order[k].HasSameId(order[k - 1]) &&
      getCorners(order[k - 1].Element) == getCorners(cell);
    if (!isAgain)
    {
      numbering.Cells.push_back(cell);
    }
    numbering.Pieces[cell.Piece].Cells[cell.Index] =
      static_cast<Offset>(numbering.Cells.size()) - 1;
  }
  numbering.FirstCells[kind + 1] = static_cast<Offset>(numbering.Cells.size());
}

bool IsGhost(const unsigned char* flags, Offset i)
{
  return flags && (flags[i] & 1) != 0;
}

/// Returns, per point, true if a cell that is not a ghost uses the point. A point without cells is
/// owned unless it is a ghost.
std::vector<bool> FindOwnedPoints(const SurfacePiece& piece)
{
  std::vector<bool> isOwned(static_cast<std::size_t>(piece.NumberOfPoints));
  for (Offset i = 0; i < piece.NumberOfPoints; ++i)
  {
    isOwned[i] = !IsGhost(piece.PointFlags, i);
  }
  for (const bool areOwned : { false, true }) // points of both kinds of cells are owned
  {
    Offset cell = 0;
    for (const CellArrays& cells : piece.Cells)
    {
      for (Offset i = 0; i < cells.NumberOfCells; ++i, ++cell)
      {
        if (IsGhost(piece.CellFlags, cell) != areOwned)
        {
          std::for_each(
            cells.Begin(i), cells.End(i), [&](Offset point) { isOwned[point] = areOwned; });
        }
      }
    }
  }
  return isOwned;
}

/// Adds an element of piece 0 to a surface if it is kept.
void AddIf(bool isKept, std::vector<Offset>& ids, std::vector<PieceElement>& elements)
{
  const auto index = static_cast<Offset>(ids.size());
  ids.push_back(isKept ? static_cast<Offset>(elements.size()) : -1);
  if (isKept)
  {
    elements.push_back({ 0, index });
  }
}
}

//------------------------------------------------------------------------------
Offset SurfacePiece::GetNumberOfCells() const
{
  Offset count = 0;
  for (const CellArrays& cells : this->Cells)
  {
    count += cells.NumberOfCells;
  }
  return count;
}

//------------------------------------------------------------------------------
Status SurfacePiece::Check() const
{
  Offset firstCell = 0;
  for (const CellArrays& cells : this->Cells)
  {
    DGG_RETURN_IF_ERROR(cells.Check(firstCell, this->NumberOfPoints, "a piece of the input"));
    firstCell += cells.NumberOfCells;
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
PieceIds PieceIds::MakeIdentity(Offset numberOfPoints, Offset numberOfCells)
{
  PieceIds ids;
  ids.Points.resize(static_cast<std::size_t>(numberOfPoints));
  ids.Cells.resize(static_cast<std::size_t>(numberOfCells));
  std::iota(ids.Points.begin(), ids.Points.end(), 0);
  std::iota(ids.Cells.begin(), ids.Cells.end(), 0);
  return ids;
}

//------------------------------------------------------------------------------
Status JoinSurfacePieces(const std::vector<SurfacePiece>& pieces, PieceNumbering& numbering)
{
  numbering = PieceNumbering();
  numbering.Pieces.resize(pieces.size());
  bool havePointIds = true;
  bool haveCellIds = true;
  Offset size = 0;
  for (const SurfacePiece& piece : pieces)
  {
    size += piece.NumberOfPoints;
  }
  if (size > std::numeric_limits<Id>::max())
  {
    return InvalidInput(
      "The pieces of the input have ", size, " points, more than ", std::numeric_limits<Id>::max())
      .Fix("Use fewer points");
  }
  std::vector<Id> first{ 0 }; // id of the first point of each piece, counted over all pieces
  for (const SurfacePiece& piece : pieces)
  {
    DGG_RETURN_IF_ERROR(piece.Check());
    havePointIds = havePointIds && (piece.PointIds || piece.NumberOfPoints == 0);
    haveCellIds = haveCellIds && (piece.CellIds || piece.GetNumberOfCells() == 0);
    first.push_back(first.back() + static_cast<Id>(piece.NumberOfPoints));
  }
  DisjointSets points(static_cast<std::size_t>(size));
  if (havePointIds)
  {
    DGG_RETURN_IF_ERROR(JoinGlobalIds(pieces, first, points));
  }
  else
  {
    JoinRims(pieces, points);
  }
  NumberPoints(pieces, first, havePointIds, points, numbering);
  for (int kind = 0; kind < NumberOfCellKinds; ++kind)
  {
    NumberCells(pieces, kind, haveCellIds, numbering);
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
bool HasGhosts(const unsigned char* flags, Offset size)
{
  return flags &&
    std::any_of(flags, flags + size, [](unsigned char flag) { return IsGhost(&flag, 0); });
}

//------------------------------------------------------------------------------
Status ExcludeGhosts(const SurfacePiece& piece, PieceNumbering& numbering)
{
  DGG_RETURN_IF_ERROR(piece.Check());
  numbering = PieceNumbering();
  PieceIds& ids = numbering.Pieces.emplace_back();
  for (const bool isOwned : FindOwnedPoints(piece))
  {
    AddIf(isOwned, ids.Points, numbering.Points);
  }
  Offset cell = 0;
  for (int kind = 0; kind < NumberOfCellKinds; ++kind)
  {
    for (const Offset end = cell + piece.Cells[kind].NumberOfCells; cell < end; ++cell)
    {
      AddIf(!IsGhost(piece.CellFlags, cell), ids.Cells, numbering.Cells);
    }
    numbering.FirstCells[kind + 1] = static_cast<Offset>(numbering.Cells.size());
  }
  return Status::Success();
}
}
