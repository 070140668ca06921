// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggIsolineParts.h"

#include "dggPieceChains.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace dgg
{
namespace
{
/// Lines between two progress reports.
constexpr std::size_t ProgressInterval = 1024;

/// Returns the curves joined into chains. A chain has the direction of its curve with the smallest
/// index, and starts with this curve if closed. Chains are sorted by level, then by this curve.
std::vector<PieceChain> JoinCurves(const std::vector<FaceCurve>& curves)
{
  std::vector<std::array<Id, 2>> ends;
  ends.reserve(curves.size());
  for (const FaceCurve& curve : curves)
  {
    const Id own =
      -2 - static_cast<Id>(ends.size()); // unique end of a closed curve, which meets no other
    ends.push_back(
      { { curve.First == NoId ? own : curve.First, curve.First == NoId ? own : curve.Last } });
  }
  std::vector<PieceChain> chains = JoinPieces(ends);
  std::vector<std::tuple<Id, std::size_t, std::size_t>> order; // level, first curve, chain
  order.reserve(chains.size());
  for (std::size_t c = 0; c < chains.size(); ++c)
  {
    std::vector<PiecePassage>& passages = chains[c].Passages;
    auto first = std::min_element(passages.begin(), passages.end(),
      [](const PiecePassage& a, const PiecePassage& b) { return a.Piece < b.Piece; });
    order.emplace_back(curves[first->Piece].Level, first->Piece, c);
    if (first->IsBackward)
    {
      std::reverse(passages.begin(), passages.end());
      first = passages.end() - 1 - (first - passages.begin());
      for (PiecePassage& passage : passages)
      {
        passage.IsBackward = !passage.IsBackward;
      }
    }
    if (chains[c].IsClosed)
    {
      std::rotate(passages.begin(), first, passages.end());
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<PieceChain> sorted;
  sorted.reserve(chains.size());
  for (const auto& place : order)
  {
    sorted.push_back(std::move(chains[std::get<2>(place)]));
  }
  return sorted;
}

/// Converts a chain of curves into a line.
SurfacePath Draw(const SurfaceMesh& mesh, const std::vector<LevelCrossing>& crossings,
  const std::vector<FaceCurve>& curves, const PieceChain& chain)
{
  SurfacePath line;
  const auto append = [&](const SurfacePoint& point, Id face) {
    if (line.Points.empty() || !IsSamePoint(line.Points.back(), point))
    {
      line.Append(mesh, point, face);
    }
  };
  const auto appendCrossing = [&](Id crossing, Id face) {
    if (crossing != NoId)
    {
      const LevelCrossing& c = crossings[crossing];
      const double t = std::min(1.0, std::max(0.0, c.X / mesh.Length(c.HalfEdge)));
      append(SurfacePoint::OnEdge(mesh, c.HalfEdge, t), face);
    }
  };
  for (const PiecePassage& passage : chain.Passages)
  {
    const FaceCurve& curve = curves[passage.Piece];
    appendCrossing(passage.IsBackward ? curve.Last : curve.First, curve.Face);
    for (std::size_t i = 0; i < curve.Points.size(); ++i)
    {
      const std::size_t at = passage.IsBackward ? curve.Points.size() - 1 - i : i;
      append(
        SurfacePoint::InTriangle(mesh, curve.Face, ClampedToFace(curve.Points[at])), curve.Face);
    }
    appendCrossing(passage.IsBackward ? curve.First : curve.Last, curve.Face);
  }
  if (chain.IsClosed && !line.Points.empty())
  {
    append(SurfacePoint(line.Points.front()), curves[chain.Passages.back().Piece].Face);
  }
  return line;
}
}

bool IsEdgeTraced(const DistanceField& field, Id h)
{
  bool isTraced = false;
  ForEachHalfEdge(
    *field.Mesh, h, [&](Id e) { isTraced = isTraced || field.IsTraced(SurfaceMesh::Face(e)); });
  return isTraced;
}

Status JoinFaceCurves(const SurfaceMesh& mesh, const std::vector<LevelCrossing>& crossings,
  const std::vector<FaceCurve>& curves, const ProgressCallback& progress, Isolines& lines)
{
  const std::vector<PieceChain> chains = JoinCurves(curves);
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    if (i % ProgressInterval == 0)
    {
      DGG_RETURN_IF_ERROR(
        ReportTo(progress, static_cast<double>(i) / static_cast<double>(chains.size())));
    }
    SurfacePath line = Draw(mesh, crossings, curves, chains[i]);
    if (!line.Faces.empty())
    {
      lines.Lines.push_back(std::move(line));
      lines.Levels.push_back(curves[chains[i].Passages.front().Piece].Level);
      lines.IsClosed.push_back(chains[i].IsClosed);
    }
  }
  return Status::Success();
}
}
