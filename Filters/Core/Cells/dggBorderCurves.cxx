// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBorderCurves.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace dgg
{
namespace
{
/// One end of a piece.
struct PieceEnd
{
  Id Point;
  std::size_t Piece;
};

/// The pieces between one pair of cells.
class Joiner
{
public:
  Joiner(const BorderPiece* begin, std::size_t size, VoronoiDiagram& diagram)
    : Pieces(begin)
    , IsUsed(size, 0)
    , Diagram(diagram)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Ends.push_back({ begin[i].Points[0], i });
      this->Ends.push_back({ begin[i].Points[1], i });
    }
    std::sort(this->Ends.begin(), this->Ends.end(), [](const PieceEnd& a, const PieceEnd& b) {
      return std::tie(a.Point, a.Piece) < std::tie(b.Point, b.Piece);
    });
  }

  void Run()
  {
    // Curves with ends first; what is left are closed ones.
    for (const PieceEnd& end : this->Ends)
    {
      if (!this->IsUsed[end.Piece] && this->CountAt(end.Point) != 2)
      {
        this->Follow(end);
      }
    }
    for (const PieceEnd& end : this->Ends)
    {
      if (!this->IsUsed[end.Piece])
      {
        this->Follow(end);
      }
    }
  }

private:
  using Range =
    std::pair<std::vector<PieceEnd>::const_iterator, std::vector<PieceEnd>::const_iterator>;

  Range At(Id point) const
  {
    return std::equal_range(this->Ends.begin(), this->Ends.end(), PieceEnd{ point, 0 },
      [](const PieceEnd& a, const PieceEnd& b) { return a.Point < b.Point; });
  }

  std::ptrdiff_t CountAt(Id point) const
  {
    const Range range = this->At(point);
    return range.second - range.first;
  }

  void Follow(const PieceEnd& start)
  {
    std::vector<Id>& points = this->Diagram.CurvePoints;
    points.push_back(start.Point);
    Id point = start.Point;
    std::size_t piece = start.Piece;
    bool goesOn = true;
    while (goesOn)
    {
      this->IsUsed[piece] = 1;
      const std::array<Id, 2>& ends = this->Pieces[piece].Points;
      point = ends[0] == point ? ends[1] : ends[0];
      points.push_back(point);
      const Range range = this->At(point);
      goesOn = false;
      if (range.second - range.first == 2)
      {
        for (auto end = range.first; end != range.second; ++end)
        {
          goesOn = goesOn || !this->IsUsed[end->Piece];
          piece = this->IsUsed[end->Piece] ? piece : end->Piece;
        }
      }
    }
    this->Diagram.CurveOffsets.push_back(static_cast<Offset>(points.size()));
    this->Diagram.CurveSites.push_back(this->Pieces[start.Piece].Sites);
  }

  const BorderPiece* Pieces;
  std::vector<char> IsUsed;
  VoronoiDiagram& Diagram;
  std::vector<PieceEnd> Ends; ///< by points
};
}

void JoinBorderPieces(std::vector<BorderPiece>& pieces, VoronoiDiagram& diagram)
{
  const auto key = [](const BorderPiece& piece) { return std::tie(piece.Sites, piece.Points); };
  std::sort(pieces.begin(), pieces.end(),
    [&key](const BorderPiece& a, const BorderPiece& b) { return key(a) < key(b); });
  pieces.erase(std::unique(pieces.begin(), pieces.end(),
                 [&key](const BorderPiece& a, const BorderPiece& b) { return key(a) == key(b); }),
    pieces.end());
  for (std::size_t begin = 0; begin < pieces.size();)
  {
    std::size_t end = begin;
    while (end < pieces.size() && pieces[end].Sites == pieces[begin].Sites)
    {
      ++end;
    }
    Joiner(pieces.data() + begin, end - begin, diagram).Run();
    begin = end;
  }
}
}
