// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLayoutOrder.h"

#include "dggStatus.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace dgg
{
namespace
{
Status CheckLandmark(Id landmark, Id count, const std::string& where)
{
  if (landmark >= 0 && landmark < count)
  {
    return Status::Success();
  }
  return InvalidInput(where, " refers to landmark ", landmark, ", but there are ", count)
    .Fix("Use landmarks from 0 to ", count - 1);
}

std::string Name(const std::string& what, std::size_t index)
{
  return what + " " + std::to_string(index) + " of the layout";
}
}

EdgeOrder EdgeOrder::Reversed() const
{
  EdgeOrder reversed = *this;
  std::reverse(reversed.Edges.begin(), reversed.Edges.end());
  return reversed;
}

Status LayoutOrder::Read(const PatchLayout& layout, Id numberOfLandmarks)
{
  this->Edges.clear();
  this->Orders.clear();
  DGG_RETURN_IF_ERROR(this->ReadPatches(layout, numberOfLandmarks));
  DGG_RETURN_IF_ERROR(this->AddEdges(layout, numberOfLandmarks));
  if (this->Edges.empty())
  {
    return InvalidInput("The layout is empty").Fix("Add patches, or edges between landmarks");
  }
  this->FindOrders(layout, numberOfLandmarks);
  return Status::Success();
}

Status LayoutOrder::ReadPatches(const PatchLayout& layout, Id numberOfLandmarks)
{
  std::map<std::pair<Id, Id>, std::size_t> sides; // directed sides, and their patch
  for (std::size_t p = 0; p < layout.Patches.size(); ++p)
  {
    const std::vector<Id>& patch = layout.Patches[p];
    const std::string name = Name("Patch", p);
    if (patch.size() < 3)
    {
      return InvalidInput(name, " has fewer than three landmarks")
        .Fix("Add landmarks, or remove the patch");
    }
    for (std::size_t i = 0; i < patch.size(); ++i)
    {
      const Id a = patch[i];
      const Id b = patch[(i + 1) % patch.size()];
      DGG_RETURN_IF_ERROR(CheckLandmark(a, numberOfLandmarks, name));
      if (a == b)
      {
        return InvalidInput(name, " has landmark ", a, " twice in succession")
          .Fix("Remove one of the two");
      }
      const auto added = sides.emplace(std::make_pair(a, b), p);
      if (!added.second)
      {
        return InvalidInput("Patches ", added.first->second, " and ", p,
          " of the layout both pass from landmark ", a, " to ", b)
          .Fix("Reverse one of them: an edge has at most two patches, which pass it in opposite "
               "directions");
      }
      if (sides.find({ b, a }) == sides.end())
      {
        this->Edges.push_back({ { a, b } });
      }
    }
  }
  return Status::Success();
}

Status LayoutOrder::AddEdges(const PatchLayout& layout, Id numberOfLandmarks)
{
  std::set<std::pair<Id, Id>> known;
  auto key = [](Id a, Id b) { return std::make_pair(std::min(a, b), std::max(a, b)); };
  for (const std::array<Id, 2>& edge : this->Edges)
  {
    known.insert(key(edge[0], edge[1]));
  }
  std::set<std::pair<Id, Id>> added;
  for (std::size_t e = 0; e < layout.Edges.size(); ++e)
  {
    const std::array<Id, 2>& edge = layout.Edges[e];
    for (const Id landmark : edge)
    {
      DGG_RETURN_IF_ERROR(CheckLandmark(landmark, numberOfLandmarks, Name("Edge", e)));
    }
    if (edge[0] == edge[1])
    {
      return InvalidInput(Name("Edge", e), " joins landmark ", edge[0], " to itself")
        .Fix("Remove the edge");
    }
    if (!added.insert(key(edge[0], edge[1])).second)
    {
      return InvalidInput(
        Name("Edge", e), ", between landmarks ", edge[0], " and ", edge[1], ", occurs twice")
        .Fix("Remove one of the two");
    }
    if (known.insert(key(edge[0], edge[1])).second)
    {
      this->Edges.push_back(edge);
    }
  }
  return Status::Success();
}

/// Finds the orders from the corners of the patches: counter-clockwise, the side that leaves a
/// landmark is followed by the side that arrives at the landmark.
void LayoutOrder::FindOrders(const PatchLayout& layout, Id numberOfLandmarks)
{
  std::vector<std::vector<Id>> around(numberOfLandmarks);
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    around[this->Edges[e][0]].push_back(static_cast<Id>(e));
    around[this->Edges[e][1]].push_back(static_cast<Id>(e));
  }
  std::vector<std::map<Id, Id>> next(numberOfLandmarks);
  for (const std::vector<Id>& patch : layout.Patches)
  {
    for (std::size_t i = 0; i < patch.size(); ++i)
    {
      const Id before = patch[(i + patch.size() - 1) % patch.size()];
      const Id after = patch[(i + 1) % patch.size()];
      next[patch[i]][this->FindEdge(patch[i], after)] = this->FindEdge(patch[i], before);
    }
  }
  this->Orders.assign(numberOfLandmarks, EdgeOrder());
  for (Id l = 0; l < numberOfLandmarks; ++l)
  {
    if (around[l].empty())
    {
      continue;
    }
    // If the order has a gap, start with the edge after the gap.
    EdgeOrder& order = this->Orders[l];
    Id first = around[l][0];
    for (const Id e : around[l])
    {
      const bool hasPrevious = std::any_of(next[l].begin(), next[l].end(),
        [&](const std::pair<const Id, Id>& step) { return step.second == e; });
      if (!hasPrevious)
      {
        first = e;
        order.HasGap = true;
      }
    }
    Id e = first;
    do
    {
      order.Edges.push_back(e);
      const auto step = next[l].find(e);
      e = step != next[l].end() ? step->second : NoId;
    } while (e != NoId && e != first && order.Edges.size() <= around[l].size());
    order.IsKnown =
      order.Edges.size() == around[l].size() && (order.HasGap ? e == NoId : e == first);
    if (!order.IsKnown)
    {
      order = EdgeOrder();
    }
  }
}

Id LayoutOrder::FindEdge(Id a, Id b) const
{
  const auto edge =
    std::find_if(this->Edges.begin(), this->Edges.end(), [&](const std::array<Id, 2>& e) {
      return (e[0] == a && e[1] == b) || (e[0] == b && e[1] == a);
    });
  return edge != this->Edges.end() ? static_cast<Id>(edge - this->Edges.begin()) : NoId;
}

namespace
{
/// Returns the curve that leaves a landmark towards a neighbor.
Id FindCurve(const DrawnSurface& surface, const std::vector<std::array<Id, 2>>& edges, Id landmark,
  Id neighbor)
{
  const std::size_t landmarks = surface.Refined.Paths.size() - surface.DrawnEdges.size();
  for (std::size_t i = 0; i < surface.DrawnEdges.size(); ++i)
  {
    const Id e = surface.DrawnEdges[i];
    const std::vector<Id>& chain = surface.Refined.Paths[landmarks + i];
    if ((edges[e][0] == landmark && chain[1] == neighbor) ||
      (edges[e][1] == landmark && chain[chain.size() - 2] == neighbor))
    {
      return e;
    }
  }
  return NoId;
}

/// Returns true if the order allows an edge in a sector.
bool Allows(
  const LayoutSector& sector, const DrawnSurface& surface, const EdgeOrder& order, Id edge)
{
  const auto place = std::find(order.Edges.begin(), order.Edges.end(), edge);
  if (sector.IsWhole || place == order.Edges.end())
  {
    return true;
  }
  // The nearest drawn edges before and after it.
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
  // Next to the boundary of the surface.
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
    return; // already known
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
