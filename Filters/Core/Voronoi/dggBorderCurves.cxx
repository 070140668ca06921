// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBorderCurves.h"

#include "dggVoronoi.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace dgg
{
/// The pieces between one pair of cells.
class BorderCurves::Joiner
{
public:
  Joiner(const Piece* begin, std::size_t size, VoronoiDiagram& diagram)
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
  /// One end of a piece.
  struct PieceEnd
  {
    Id Point;
    std::size_t Piece;
  };

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

  const Piece* Pieces;
  std::vector<char> IsUsed;
  VoronoiDiagram& Diagram;
  std::vector<PieceEnd> Ends; ///< by points
};

void BorderCurves::AddPiece(Id site, Id other, const std::array<Id, 2>& points)
{
  if (site != other)
  {
    this->Pieces.push_back({ { { std::min(site, other), std::max(site, other) } }, points });
  }
}

/// All cells along a piece of an edge: those that were added, and its owner where there are more
/// faces.
void BorderCurves::AddPiecesOfSide(const SurfaceMesh& mesh, Side begin, Side end)
{
  std::vector<Id> sites;
  for (auto side = begin; side != end; ++side)
  {
    sites.push_back(side->Site);
  }
  std::ptrdiff_t faces = 1;
  for (Id e = mesh.Twin(begin->HalfEdge); e != NoId && e != begin->HalfEdge; e = mesh.Twin(e))
  {
    ++faces;
  }
  if (end - begin < faces)
  {
    sites.push_back(begin->Owner);
  }
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      this->AddPiece(sites[i], sites[j], begin->Points);
    }
  }
}

void BorderCurves::AddTo(const SurfaceMesh& mesh, VoronoiDiagram& diagram)
{
  std::sort(this->Sides.begin(), this->Sides.end(), [](const BorderSide& a, const BorderSide& b) {
    return std::tie(a.Points, a.Site) < std::tie(b.Points, b.Site);
  });
  for (auto begin = this->Sides.cbegin(); begin != this->Sides.cend();)
  {
    const auto end = std::find_if(begin, this->Sides.cend(),
      [begin](const BorderSide& side) { return side.Points != begin->Points; });
    this->AddPiecesOfSide(mesh, begin, end);
    begin = end;
  }
  const auto key = [](const Piece& piece) { return std::tie(piece.Sites, piece.Points); };
  std::sort(this->Pieces.begin(), this->Pieces.end(),
    [&key](const Piece& a, const Piece& b) { return key(a) < key(b); });
  const auto last = std::unique(this->Pieces.begin(), this->Pieces.end(),
    [&key](const Piece& a, const Piece& b) { return key(a) == key(b); });
  this->Pieces.erase(last, this->Pieces.end());
  for (auto begin = this->Pieces.cbegin(); begin != this->Pieces.cend();)
  {
    const auto end = std::find_if(begin, this->Pieces.cend(),
      [begin](const Piece& piece) { return piece.Sites != begin->Sites; });
    Joiner(&*begin, static_cast<std::size_t>(end - begin), diagram).Run();
    begin = end;
  }
}
}
