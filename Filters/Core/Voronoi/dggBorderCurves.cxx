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
namespace
{
/// Marks points of several cells.
constexpr Id Shared = -2;

/// A side of a polygon, with its points in ascending order.
struct Side
{
  std::array<Id, 2> Points;
  Id Site;
  Id Face;
};

/// A segment between two sites, in ascending order.
struct Segment
{
  std::array<Id, 2> Sites;
  std::array<Id, 2> Points;
};

/// Returns the sides of polygons, sorted by points and site, without most sides that are inside a
/// cell.
std::vector<Side> CollectSides(const VoronoiDiagram& diagram)
{
  // Ends of borders belong to several cells.
  std::vector<Id> siteOf(diagram.Distances.size() + diagram.BorderPoints.size(), NoId);
  const std::size_t count = diagram.GetNumberOfPolygons();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Id site = diagram.PolygonSites[i];
    for (Offset k = diagram.PolygonOffsets[i]; k < diagram.PolygonOffsets[i + 1]; ++k)
    {
      Id& known = siteOf[diagram.PolygonPoints[k]];
      known = known == NoId || known == site ? site : Shared;
    }
  }
  std::vector<Side> sides;
  for (std::size_t i = 0; i < count; ++i)
  {
    Id from = diagram.PolygonPoints[diagram.PolygonOffsets[i + 1] - 1];
    for (Offset k = diagram.PolygonOffsets[i]; k < diagram.PolygonOffsets[i + 1]; ++k)
    {
      const Id to = diagram.PolygonPoints[k];
      if (siteOf[from] == Shared && siteOf[to] == Shared && diagram.PolygonSites[i] != NoId)
      {
        sides.push_back({ { { std::min(from, to), std::max(from, to) } }, diagram.PolygonSites[i],
          diagram.PolygonFaces[i] });
      }
      from = to;
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.Points, a.Site) < std::tie(b.Points, b.Site);
  });
  return sides;
}
}

void AddBorderCurves(const std::uint8_t* layers, VoronoiDiagram& diagram)
{
  const std::vector<Side> sides = CollectSides(diagram);
  std::vector<Segment> segments; // between each two cells at a side
  for (auto a = sides.begin(); a != sides.end(); ++a)
  {
    for (auto b = a + 1; b != sides.end() && b->Points == a->Points; ++b)
    {
      if (a->Site != b->Site && (!layers || layers[std::min(a->Face, b->Face)] == 0))
      {
        segments.push_back({ { { a->Site, b->Site } }, a->Points });
      }
    }
  }
  const auto key = [](const Segment& segment) { return std::tie(segment.Sites, segment.Points); };
  std::sort(segments.begin(), segments.end(),
    [&key](const Segment& a, const Segment& b) { return key(a) < key(b); });
  const auto last = std::unique(segments.begin(), segments.end(),
    [&key](const Segment& a, const Segment& b) { return key(a) == key(b); });
  segments.erase(last, segments.end());
  diagram.CurveOffsets.push_back(0);
  for (auto begin = segments.cbegin(); begin != segments.cend();)
  {
    std::vector<std::array<Id, 2>> points; // segments between one pair of cells
    auto end = begin;
    for (; end != segments.cend() && end->Sites == begin->Sites; ++end)
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
