// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMarchingTriangles.h"

#include "dggLevelTurns.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Distance below which a point is on a side of a triangle, relative to the largest part of the
/// triangle.
constexpr double OnSide = 1e-12;
/// Maximum number of passes that search all triangles for wavefronts between their nodes, and
/// maximum ratio of added nodes to existing ones.
constexpr int RoundsOfTurns = 12;
constexpr std::size_t MostNodes = 20;

double SignedArea(const Point2& a, const Point2& b, const Point2& c)
{
  return Cross(Difference(b, a), Difference(c, a));
}
}

void LevelRim::Clear()
{
  for (std::vector<RimCrossing>& side : this->Sides)
  {
    side.clear();
  }
}

std::size_t LevelRim::CountCrossings() const
{
  return this->Sides[0].size() + this->Sides[1].size() + this->Sides[2].size();
}

void MarchingTriangles::Build(const FaceEnvelope& envelope, const LevelArc& arc, double level,
  const LevelRim& rim, int cells, const std::vector<Point2>& seeds)
{
  this->Nodes.clear();
  this->Links.clear();
  this->Triangles.clear();
  this->Chains.clear();
  this->AddRim(envelope, arc, level, rim, cells);
  this->AddTriangles(envelope, arc, level, cells);
  for (const Point2& seed : seeds)
  {
    this->InsertSeed(arc, level, seed);
  }
  this->AddTurns(arc, level);
  this->March();
  this->Follow(arc);
}

Id MarchingTriangles::AddNode(const LevelArc& arc, double level, const Point2& place)
{
  Node node;
  node.Point = arc.Evaluate(place);
  node.IsAbove = node.Point.Sample.Distance >= level;
  this->Nodes.push_back(node);
  return static_cast<Id>(this->Nodes.size()) - 1;
}

/// Adds the nodes on the boundary, and the crossings between them.
void MarchingTriangles::AddRim(
  const FaceEnvelope& envelope, const LevelArc& arc, double level, const LevelRim& rim, int cells)
{
  const std::array<Point2, 3>& corners = envelope.GetCorners();
  for (const Point2& corner : corners)
  {
    this->AddNode(arc, level, corner);
  }
  for (int k = 0; k < 3; ++k)
  {
    this->Nodes[k].IsAbove = rim.IsAbove[k];
    this->Nodes[k].IsOnSide[k] = true;
    this->Nodes[(k + 1) % 3].IsOnSide[k] = true;
    const Point2& from = corners[k];
    const Point2& to = corners[(k + 1) % 3];
    const std::vector<RimCrossing>& side = rim.Sides[k];
    this->RimNodes[k].assign(1, k);
    this->Between[k].assign(cells, {});
    bool isAbove = rim.IsAbove[k];
    Id previous = k;
    std::size_t next = 0;
    auto step = [&](double t) {
      const Id node =
        this->AddNode(arc, level, { from.X + t * (to.X - from.X), from.Y + t * (to.Y - from.Y) });
      this->Nodes[node].IsAbove = isAbove;
      this->Nodes[node].IsOnSide[k] = true;
      return node;
    };
    auto connect = [&](Id node, const RimCrossing* crossing) {
      if (crossing)
      {
        const Id link = this->AddLink(std::min(previous, node), std::max(previous, node));
        this->Links[link].Crossing = crossing->Index;
      }
      previous = node;
    };
    for (int i = 0; i < cells; ++i)
    {
      const double end = static_cast<double>(i + 1) / cells;
      const bool isLast = i + 1 == cells;
      const RimCrossing* open = nullptr;
      for (; next < side.size() && (isLast || side[next].T <= end); ++next)
      {
        if (open)
        {
          const Id node = step(0.5 * (open->T + side[next].T));
          this->Between[k][i].push_back(node);
          connect(node, open);
        }
        open = &side[next];
        isAbove = !isAbove;
      }
      const Id node = isLast ? (k + 1) % 3 : step(end);
      connect(node, open);
      this->RimNodes[k].push_back(node);
    }
  }
}

void MarchingTriangles::AddTriangles(
  const FaceEnvelope& envelope, const LevelArc& arc, double level, int cells)
{
  const std::array<Point2, 3>& corners = envelope.GetCorners();
  // Node (i, j) is i steps from corner 0 towards corner 1 and j towards corner 2.
  std::vector<Id> nodes(static_cast<std::size_t>((cells + 1) * (cells + 1)), NoId);
  auto at = [&](int i, int j) -> Id& { return nodes[j * (cells + 1) + i]; };
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i + j <= cells; ++i)
    {
      const double s = static_cast<double>(i) / cells;
      const double t = static_cast<double>(j) / cells;
      at(i, j) = j == 0 ? this->RimNodes[0][i]
        : i == 0        ? this->RimNodes[2][cells - j]
        : i + j == cells
        ? this->RimNodes[1][j]
        : this->AddNode(arc, level,
            { corners[0].X + s * (corners[1].X - corners[0].X) + t * (corners[2].X - corners[0].X),
              corners[0].Y + s * (corners[1].Y - corners[0].Y) +
                t * (corners[2].Y - corners[0].Y) });
    }
  }
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i + j < cells; ++i)
    {
      this->AddCell(arc, level, { { at(i, j), at(i + 1, j), at(i, j + 1) } },
        { { j == 0 ? &this->Between[0][i] : nullptr,
          i + j + 1 == cells ? &this->Between[1][j] : nullptr,
          i == 0 ? &this->Between[2][cells - 1 - j] : nullptr } });
      if (i + j + 1 < cells)
      {
        this->AddCell(arc, level, { { at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) } },
          { { nullptr, nullptr, nullptr } });
      }
    }
  }
}

/// Adds a cell. A cell with further nodes on its sides is divided from its center.
void MarchingTriangles::AddCell(const LevelArc& arc, double level, const Triangle& corners,
  const std::array<const std::vector<Id>*, 3>& between)
{
  this->Polygon.clear();
  for (int k = 0; k < 3; ++k)
  {
    this->Polygon.push_back(corners[k]);
    if (between[k])
    {
      this->Polygon.insert(this->Polygon.end(), between[k]->begin(), between[k]->end());
    }
  }
  if (this->Polygon.size() == 3)
  {
    this->Triangles.push_back(corners);
    return;
  }
  Point2 middle;
  for (const Id corner : corners)
  {
    middle.X += this->Nodes[corner].Point.Place.X / 3.0;
    middle.Y += this->Nodes[corner].Point.Place.Y / 3.0;
  }
  const Id node = this->AddNode(arc, level, middle);
  for (std::size_t i = 0; i < this->Polygon.size(); ++i)
  {
    this->Triangles.push_back(
      { { this->Polygon[i], this->Polygon[(i + 1) % this->Polygon.size()], node } });
  }
}

/// Inserts a seed into the triangle that contains it.
void MarchingTriangles::InsertSeed(const LevelArc& arc, double level, const Point2& seed)
{
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const Triangle triangle = this->Triangles[t];
    std::array<double, 3> areas{};
    for (int k = 0; k < 3; ++k)
    {
      areas[k] = SignedArea(
        this->Nodes[triangle[k]].Point.Place, this->Nodes[triangle[(k + 1) % 3]].Point.Place, seed);
    }
    const double least = std::min({ areas[0], areas[1], areas[2] });
    const double largest = std::max({ areas[0], areas[1], areas[2] });
    // Because of rounding, a seed on the common side of two triangles may be in neither.
    if (!(largest > 0.0) || !(least >= -OnSide * largest))
    {
      continue;
    }
    if (areas[0] + areas[1] + areas[2] - largest <= 1e-9 * largest)
    {
      return; // coincides with a node
    }
    const Id node = this->AddNode(arc, level, seed);
    const auto nearest =
      static_cast<int>(std::min_element(areas.begin(), areas.end()) - areas.begin());
    if (least <= OnSide * largest)
    {
      this->CutSide(triangle[nearest], triangle[(nearest + 1) % 3], node);
      return;
    }
    this->Divide(t, node);
    return;
  }
}

/// Divides a triangle at a node inside it.
void MarchingTriangles::Divide(std::size_t t, Id node)
{
  const Triangle triangle = this->Triangles[t];
  this->Triangles[t] = { { triangle[0], triangle[1], node } };
  this->Triangles.push_back({ { triangle[1], triangle[2], node } });
  this->Triangles.push_back({ { triangle[2], triangle[0], node } });
}

/// Divides the triangles on both sides of edge ab at a node between a and b.
void MarchingTriangles::CutSide(Id a, Id b, Id node)
{
  const std::size_t count = this->Triangles.size();
  for (std::size_t t = 0; t < count; ++t)
  {
    const Triangle triangle = this->Triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      const Id from = triangle[k];
      const Id to = triangle[(k + 1) % 3];
      const Id opposite = triangle[(k + 2) % 3];
      if ((from == a && to == b) || (from == b && to == a))
      {
        this->Triangles[t] = { { from, node, opposite } };
        this->Triangles.push_back({ { node, to, opposite } });
      }
    }
  }
}

/// Divides triangles until no side is crossed more than once, because wavefronts may be narrower
/// than the triangles. Existing sides are processed before new ones, since processing new sides
/// first could lead to slivers along a side that has to be divided itself.
void MarchingTriangles::AddTurns(const LevelArc& arc, double level)
{
  this->Searched.clear();
  const std::size_t most = MostNodes * this->Nodes.size();
  bool isCut = true;
  for (int round = 0; round < RoundsOfTurns && isCut; ++round)
  {
    isCut = false;
    std::vector<Side> sides;
    sides.reserve(3 * this->Triangles.size());
    for (const Triangle& triangle : this->Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        sides.emplace_back(std::minmax(triangle[k], triangle[(k + 1) % 3]));
      }
    }
    for (std::size_t i = 0; i < sides.size() && this->Nodes.size() < most; ++i)
    {
      isCut = this->CutAtTurns(arc, level, sides[i].first, sides[i].second) || isCut;
    }
  }
}

bool MarchingTriangles::CutAtTurns(const LevelArc& arc, double level, Id a, Id b)
{
  if (this->IsOnRim(a, b) || !this->Searched.insert(std::minmax(a, b)).second)
  {
    return false;
  }
  this->Turns.clear();
  FindTurns(arc, level, { this->Nodes[a].Point, this->Nodes[a].IsAbove },
    { this->Nodes[b].Point, this->Nodes[b].IsAbove }, this->Turns);
  Id previous = a;
  for (const LevelPoint& turn : this->Turns)
  {
    const Id node = this->AddNode(arc, level, turn.Place);
    this->CutSide(previous, b, node);
    this->Searched.insert(std::minmax(previous, node));
    previous = node;
  }
  this->Searched.insert(std::minmax(previous, b));
  return !this->Turns.empty();
}

/// Returns true if the side between two nodes lies on the boundary, on which the crossings decide.
bool MarchingTriangles::IsOnRim(Id a, Id b) const
{
  for (int k = 0; k < 3; ++k)
  {
    if (this->Nodes[a].IsOnSide[k] && this->Nodes[b].IsOnSide[k])
    {
      return true;
    }
  }
  return false;
}

Id MarchingTriangles::AddLink(Id low, Id high)
{
  this->Links.push_back({ low, high, this->Nodes[low].LastLink });
  this->Nodes[low].LastLink = static_cast<Id>(this->Links.size()) - 1;
  return this->Nodes[low].LastLink;
}

/// Returns the link between two nodes. Adds the link if it does not exist.
Id MarchingTriangles::FindLink(Id a, Id b)
{
  const Id low = std::min(a, b);
  const Id high = std::max(a, b);
  for (Id i = this->Nodes[low].LastLink; i != NoId; i = this->Links[i].Before)
  {
    if (this->Links[i].High == high)
    {
      return i;
    }
  }
  return this->AddLink(low, high);
}

void MarchingTriangles::March()
{
  for (const Triangle& triangle : this->Triangles)
  {
    Id first = NoId;
    Id last = NoId;
    for (int k = 0; k < 3; ++k)
    {
      const Id from = triangle[k];
      const Id to = triangle[(k + 1) % 3];
      const bool isAbove = this->Nodes[from].IsAbove;
      if (isAbove != this->Nodes[to].IsAbove)
      {
        // The isoline enters at a point where the boundary rises, so that lower distances are on
        // the left of the isoline.
        (isAbove ? last : first) = this->FindLink(from, to);
      }
    }
    if (first != NoId)
    {
      this->Links[first].Next = last;
      this->Links[last].IsReached = true;
    }
  }
}

void MarchingTriangles::Follow(const LevelArc& arc)
{
  for (std::size_t i = 0; i < this->Links.size(); ++i)
  {
    if (!this->Links[i].IsReached && this->Links[i].Next != NoId)
    {
      this->FollowFrom(arc, static_cast<Id>(i));
    }
  }
  for (std::size_t i = 0; i < this->Links.size(); ++i)
  {
    if (this->Links[i].Next != NoId)
    {
      this->FollowFrom(arc, static_cast<Id>(i)); // closed
    }
  }
}

void MarchingTriangles::FollowFrom(const LevelArc& arc, Id link)
{
  this->Chains.emplace_back();
  LevelChain& chain = this->Chains.back();
  while (link != NoId)
  {
    Link& at = this->Links[link];
    const Id next = at.Next;
    at.Next = NoId; // done
    if (at.Crossing != NoId)
    {
      (next != NoId ? chain.First : chain.Last) = at.Crossing;
    }
    else if (next != NoId)
    {
      const Node& a = this->Nodes[at.Low];
      const Node& b = this->Nodes[at.High];
      chain.Points.push_back(
        arc.FindBetween(a.IsAbove ? b.Point : a.Point, a.IsAbove ? a.Point : b.Point));
    }
    link = next;
  }
}
}
