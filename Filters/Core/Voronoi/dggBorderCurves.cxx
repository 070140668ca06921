// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBorderCurves.h"

#include "dggPieceChains.h"
#include "dggVoronoi.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace dgg
{
void BorderCurves::AddPiece(Id site, Id other, const std::array<Id, 2>& points)
{
  if (site != other)
  {
    this->Pieces.push_back({ { { std::min(site, other), std::max(site, other) } }, points });
  }
}

/// Adds borders between all cells along an edge segment: the cells of the given sides, and the
/// owner of the segment if the edge has further faces.
void BorderCurves::AddPiecesOfSide(const SurfaceMesh& mesh, Side begin, Side end)
{
  std::vector<Id> sites;
  for (auto side = begin; side != end; ++side)
  {
    sites.push_back(side->Site);
  }
  std::ptrdiff_t faces = 0;
  ForEachHalfEdge(mesh, begin->HalfEdge, [&](Id) { ++faces; });
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
    std::vector<std::array<Id, 2>> points; // segments between one pair of cells
    auto end = begin;
    for (; end != this->Pieces.cend() && end->Sites == begin->Sites; ++end)
    {
      points.push_back(end->Points);
    }
    for (const PieceChain& chain : JoinPieces(points))
    {
      const PiecePassage& first = chain.Passages.front();
      diagram.CurvePoints.push_back(points[first.Piece][first.IsBackward ? 1 : 0]);
      for (const PiecePassage& passage : chain.Passages)
      {
        diagram.CurvePoints.push_back(points[passage.Piece][passage.IsBackward ? 0 : 1]);
      }
      diagram.CurveOffsets.push_back(static_cast<Offset>(diagram.CurvePoints.size()));
      diagram.CurveSites.push_back(begin->Sites);
    }
    begin = end;
  }
}
}
