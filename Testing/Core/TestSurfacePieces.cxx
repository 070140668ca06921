// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Pieces of a surface: which points and cells are identified, and how they are numbered.
#include "dggSurfacePieces.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace
{
using Offsets = std::vector<dgg::Offset>;

/// Arrays of a piece with triangles.
struct Triangles
{
  std::vector<double> Points;
  Offsets Ids;
  Offsets PointIds{};
  Offsets CellIds{};
  std::vector<unsigned char> PointFlags{};
  std::vector<unsigned char> CellFlags{};
  int Block = 0;
  Offsets CellOffsets{};

  dgg::SurfacePiece Get()
  {
    const auto count = static_cast<dgg::Offset>(this->Ids.size() / 3);
    for (dgg::Offset i = 0; i <= count; ++i)
    {
      this->CellOffsets.push_back(3 * i);
    }
    dgg::SurfacePiece piece;
    piece.Block = this->Block;
    piece.Points = this->Points.data();
    piece.NumberOfPoints = static_cast<dgg::Offset>(this->Points.size() / 3);
    piece.Cells[2] = { count, this->CellOffsets.data(), this->Ids.data(), 3 * count };
    piece.PointIds = this->PointIds.empty() ? nullptr : this->PointIds.data();
    piece.CellIds = this->CellIds.empty() ? nullptr : this->CellIds.data();
    piece.PointFlags = this->PointFlags.empty() ? nullptr : this->PointFlags.data();
    piece.CellFlags = this->CellFlags.empty() ? nullptr : this->CellFlags.data();
    return piece;
  }
};

/// Two halves of the unit square, which share the diagonal from (0, 0) to (1, 1).
Triangles LowerHalf()
{
  return { { 0, 0, 0, 1, 0, 0, 1, 1, 0 }, { 0, 1, 2 } };
}
Triangles UpperHalf()
{
  return { { 1, 1, 0, 0, 1, 0, 0, 0, 0 }, { 0, 1, 2 } };
}

dgg::PieceNumbering Join(std::vector<Triangles> triangles)
{
  std::vector<dgg::SurfacePiece> pieces;
  pieces.reserve(triangles.size());
  for (Triangles& piece : triangles)
  {
    pieces.push_back(piece.Get());
  }
  dgg::PieceNumbering numbering;
  EXPECT_TRUE(dgg::JoinSurfacePieces(pieces, numbering).IsOk());
  return numbering;
}
}

TEST(SurfacePieces, BoundariesAreJoinedByPosition)
{
  const dgg::PieceNumbering joined = Join({ LowerHalf(), UpperHalf() });
  EXPECT_EQ(joined.Pieces[0].Points, Offsets({ 0, 1, 2 }));
  EXPECT_EQ(joined.Pieces[1].Points, Offsets({ 2, 3, 0 }));
  EXPECT_EQ(joined.Pieces[1].Cells, Offsets({ 1 }));
  EXPECT_EQ(joined.Points.size(), 4u);
}

TEST(SurfacePieces, BlocksAreNotConnected)
{
  Triangles other = UpperHalf();
  other.Block = 1;
  EXPECT_EQ(Join({ LowerHalf(), other }).Points.size(), 6u);
}

TEST(SurfacePieces, GlobalIdsDetermineOrder)
{
  Triangles lower = LowerHalf();
  Triangles upper = UpperHalf();
  lower.PointIds = { 30, 20, 10 };
  upper.PointIds = { 10, 40, 30 };
  lower.CellIds = { 8 };
  upper.CellIds = { 7 };
  const dgg::PieceNumbering joined = Join({ lower, upper });
  EXPECT_EQ(joined.Pieces[0].Points, Offsets({ 2, 1, 0 }));
  EXPECT_EQ(joined.Pieces[1].Points, Offsets({ 0, 3, 2 }));
  EXPECT_EQ(joined.Pieces[0].Cells, Offsets({ 1 }));
  EXPECT_EQ(joined.Pieces[1].Cells, Offsets({ 0 }));
}

TEST(SurfacePieces, EqualGlobalIdsAtDifferentPositionsAreRefused)
{
  Triangles lower = LowerHalf();
  Triangles upper = UpperHalf();
  lower.PointIds = upper.PointIds = { 0, 1, 2 }; // each process has numbered its own points
  dgg::PieceNumbering joined;
  const dgg::Status status = dgg::JoinSurfacePieces({ lower.Get(), upper.Get() }, joined);
  EXPECT_NE(status.GetProblem().find("global id"), std::string::npos);

  Triangles first = LowerHalf();
  Triangles second = LowerHalf();
  first.PointIds = second.PointIds = { 0, 1, 2 };
  second.Points[0] = std::numeric_limits<double>::quiet_NaN();
  const dgg::Status ofNaN = dgg::JoinSurfacePieces({ first.Get(), second.Get() }, joined);
  EXPECT_NE(ofNaN.GetProblem().find("global id"), std::string::npos);
}

TEST(SurfacePieces, EqualCellsAreJoined)
{
  Triangles twice = LowerHalf();
  twice.CellIds = { 5 };
  Triangles other = LowerHalf();
  other.CellIds = { 5 };
  Triangles point{ { 9, 9, 9 }, {} }; // a piece without cells needs no ids of cells
  const dgg::PieceNumbering joined = Join({ twice, other, point });
  EXPECT_EQ(joined.Cells.size(), 1u);
  EXPECT_EQ(joined.Points.size(), 4u);
}

TEST(SurfacePieces, GhostCellsAndTheirPointsAreExcluded)
{
  Triangles square{ { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 }, { 0, 1, 2, 0, 2, 3 } };
  square.CellFlags = { 0, 1 };
  square.PointFlags = { 1, 0, 0, 0 }; // point 0 is kept: a remaining cell uses it
  EXPECT_TRUE(dgg::HasGhosts(square.CellFlags.data(), 2));
  dgg::PieceNumbering kept;
  ASSERT_TRUE(dgg::ExcludeGhosts(square.Get(), kept).IsOk());
  EXPECT_EQ(kept.Pieces[0].Points, Offsets({ 0, 1, 2, -1 }));
  EXPECT_EQ(kept.Pieces[0].Cells, Offsets({ 0, -1 }));
}

TEST(SurfacePieces, WrongPointIdsAreRefused)
{
  Triangles wrong = LowerHalf();
  wrong.Ids[1] = 7;
  dgg::PieceNumbering joined;
  const dgg::Status status = dgg::JoinSurfacePieces({ wrong.Get() }, joined);
  EXPECT_NE(status.GetProblem().find("Cell 0"), std::string::npos);
  EXPECT_NE(status.GetProblem().find("point 7"), std::string::npos);
}
