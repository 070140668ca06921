// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLayoutSectors.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace dgg
{
namespace
{
/// The curve that leaves a landmark for a neighbour.
Id FindCurve(const DrawnSurface& surface, const std::vector<std::array<Id, 2>>& edges, Id landmark,
  Id neighbour)
{
  const std::size_t landmarks = surface.Refined.Paths.size() - surface.DrawnEdges.size();
  for (std::size_t i = 0; i < surface.DrawnEdges.size(); ++i)
  {
    const Id e = surface.DrawnEdges[i];
    const std::vector<Id>& chain = surface.Refined.Paths[landmarks + i];
    if ((edges[e][0] == landmark && chain[1] == neighbour) ||
      (edges[e][1] == landmark && chain[chain.size() - 2] == neighbour))
    {
      return e;
    }
  }
  return NoId;
}

/// Whether the order puts an edge into a sector.
bool Allows(
  const LayoutSector& sector, const DrawnSurface& surface, const EdgeOrder& order, Id edge)
{
  const auto place = std::find(order.Edges.begin(), order.Edges.end(), edge);
  if (sector.IsWhole || place == order.Edges.end())
  {
    return true;
  }
  // The nearest edges before and after it that are drawn.
  const auto size = static_cast<std::ptrdiff_t>(order.Edges.size());
  const std::ptrdiff_t index = place - order.Edges.begin();
  Id before = NoId;
  Id after = NoId;
  bool isFirst = true;
  bool isLast = true;
  for (std::ptrdiff_t step = size - 1; step > 0; --step)
  {
    const Id next = order.Edges[(index + step) % size];
    if (surface.IsDrawn[next])
    {
      after = next;
      isLast = isLast && index + step >= size;
    }
    const Id previous = order.Edges[(index - step + size) % size];
    if (surface.IsDrawn[previous])
    {
      before = previous;
      isFirst = isFirst && index - step < 0;
    }
  }
  if (sector.Begin != NoId && sector.End != NoId)
  {
    return sector.Begin == before && sector.End == after;
  }
  if (sector.Begin == NoId && sector.End == NoId)
  {
    return before == NoId;
  }
  // Beside the boundary of the surface.
  return sector.Begin == NoId ? sector.End == after && (isFirst || !order.HasGap)
                              : sector.Begin == before && (isLast || !order.HasGap);
}
}

std::vector<LayoutSector> FindSectors(
  const DrawnSurface& surface, const std::vector<std::array<Id, 2>>& edges)
{
  std::vector<LayoutSector> sectors;
  std::map<Id, Id> landmarkAt;
  for (std::size_t l = 0; l + surface.DrawnEdges.size() < surface.Refined.Paths.size(); ++l)
  {
    landmarkAt[surface.Refined.Paths[l][0]] = static_cast<Id>(l);
  }
  for (Id v = 0; v < surface.Opened.GetNumberOfVertices(); ++v)
  {
    const auto landmark = landmarkAt.find(surface.Opened.VertexOf[v]);
    const Id* fan = surface.OpenedMesh.FanBegin(v);
    if (landmark == landmarkAt.end() || fan == surface.OpenedMesh.FanEnd(v))
    {
      continue;
    }
    LayoutSector sector;
    sector.Landmark = landmark->second;
    sector.Vertex = v;
    sector.IsWhole = surface.OpenedMesh.Twin(*fan) != NoId;
    if (!sector.IsWhole)
    {
      const Id last = SurfaceMesh::Previous(*(surface.OpenedMesh.FanEnd(v) - 1));
      sector.Begin = FindCurve(surface, edges, sector.Landmark,
        surface.Opened.VertexOf[surface.OpenedMesh.Destination(*fan)]);
      sector.End = FindCurve(
        surface, edges, sector.Landmark, surface.Opened.VertexOf[surface.OpenedMesh.Origin(last)]);
    }
    sectors.push_back(sector);
  }
  return sectors;
}

std::vector<LayoutSector> FindAllowedSectors(const std::vector<LayoutSector>& sectors,
  const DrawnSurface& surface, Id landmark, const EdgeOrder& order, Id edge)
{
  std::vector<LayoutSector> allowed;
  for (const LayoutSector& sector : sectors)
  {
    if (sector.Landmark == landmark && Allows(sector, surface, order, edge))
    {
      allowed.push_back(sector);
    }
  }
  return allowed;
}

void InsertIntoOrder(EdgeOrder& order, const LayoutSector& sector, Id edge)
{
  if (std::find(order.Edges.begin(), order.Edges.end(), edge) != order.Edges.end())
  {
    return; // known
  }
  auto place = order.Edges.end();
  if (sector.Begin != NoId)
  {
    place = std::find(order.Edges.begin(), order.Edges.end(), sector.Begin);
    place += place != order.Edges.end() ? 1 : 0;
  }
  else if (sector.End != NoId)
  {
    place = std::find(order.Edges.begin(), order.Edges.end(), sector.End);
  }
  order.HasGap = !sector.IsWhole && (sector.Begin == NoId || sector.End == NoId || order.HasGap);
  order.Edges.insert(place, edge);
}
}
