// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPathNodes.h"

#include "dggEdges.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace dgg
{
PathNodes::PathNodes(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , NumberOfVertices(mesh.GetNumberOfVertices())
{
}

const std::vector<Id>* PathNodes::FindOnEdge(Id h) const
{
  const auto found =
    this->OnEdge.empty() ? this->OnEdge.end() : this->OnEdge.find(FindEdge(this->Mesh, h));
  return found == this->OnEdge.end() ? nullptr : &found->second;
}

const std::vector<Id>* PathNodes::FindInFace(Id face) const
{
  const auto found = this->InFace.find(face);
  return found == this->InFace.end() ? nullptr : &found->second;
}

std::vector<Id> PathNodes::CollectNodes(Id face) const
{
  std::vector<Id> nodes;
  for (Id h = 3 * face; h < 3 * face + 3; ++h)
  {
    nodes.push_back(this->Mesh.Origin(h));
    if (const std::vector<Id>* onEdge = this->FindOnEdge(h))
    {
      nodes.insert(nodes.end(), onEdge->begin(), onEdge->end());
    }
  }
  if (const std::vector<Id>* inside = this->FindInFace(face))
  {
    nodes.insert(nodes.end(), inside->begin(), inside->end());
  }
  return nodes;
}

PathNodes::EdgeMark PathNodes::MarkOf(const SurfacePoint& point) const
{
  const Id edge = FindEdge(this->Mesh, point.HalfEdge);
  const double t = point.Barycentric[(point.HalfEdge + 1) % 3] /
    (point.Barycentric[point.HalfEdge % 3] + point.Barycentric[(point.HalfEdge + 1) % 3]);
  const auto mark =
    static_cast<std::int64_t>(std::llround(t * static_cast<double>(GridPoint::One)));
  return { edge,
    this->Mesh.Origin(edge) == this->Mesh.Origin(point.HalfEdge) ? mark : GridPoint::One - mark };
}

Id PathNodes::Append(const Node& node)
{
  this->Nodes.push_back(node);
  return this->NumberOfVertices + static_cast<Id>(this->Nodes.size()) - 1;
}

/// Merges points on edges that are close together; points close to an end are merged with the
/// vertex.
void PathNodes::AddPointsOnEdges(const std::vector<SurfacePath>& paths)
{
  for (const SurfacePath& path : paths)
  {
    for (const SurfacePoint& point : path.Points)
    {
      if (point.On == SurfacePoint::Support::Edge)
      {
        this->Marks.push_back(this->MarkOf(point));
      }
    }
  }
  std::sort(this->Marks.begin(), this->Marks.end());
  this->Marks.erase(std::unique(this->Marks.begin(), this->Marks.end()), this->Marks.end());
  for (const EdgeMark& mark : this->Marks)
  {
    if (mark.second <= MergeDistance || mark.second >= GridPoint::One - MergeDistance)
    {
      this->MarkNodes.push_back(mark.second <= MergeDistance ? this->Mesh.Origin(mark.first)
                                                             : this->Mesh.Destination(mark.first));
      continue;
    }
    if (this->Nodes.empty() || this->Nodes.back().Edge != mark.first ||
      mark.second - this->Nodes.back().T > MergeDistance)
    {
      Node node;
      node.Edge = mark.first;
      node.T = mark.second;
      this->OnEdge[mark.first].push_back(this->Append(node));
    }
    this->MarkNodes.push_back(this->NumberOfVertices + static_cast<Id>(this->Nodes.size()) - 1);
  }
}

Id PathNodes::NodeOf(const SurfacePoint& point)
{
  if (point.On == SurfacePoint::Support::Vertex)
  {
    return point.Vertex;
  }
  if (point.On == SurfacePoint::Support::Edge)
  {
    const auto mark = std::lower_bound(this->Marks.begin(), this->Marks.end(), this->MarkOf(point));
    return this->MarkNodes[mark - this->Marks.begin()];
  }
  return this->AddCrossing(GridPoint::FromBarycentric(point.Barycentric), point.Face);
}

Id PathNodes::AddCrossing(const GridPoint& place, Id face)
{
  Id first = NoId; // first node within the merge distance
  for (auto other = this->ByPlace.lower_bound({ face, place.X - MergeDistance, 0, 0 });
       other != this->ByPlace.end() && std::get<0>(*other) == face &&
       std::get<1>(*other) <= place.X + MergeDistance;
       ++other)
  {
    if (std::abs(std::get<2>(*other) - place.Y) <= MergeDistance)
    {
      first = first == NoId ? std::get<3>(*other) : std::min(first, std::get<3>(*other));
    }
  }
  if (first != NoId)
  {
    return first;
  }
  Node node;
  node.Face = face;
  node.Place = place;
  const Id number = this->Append(node);
  this->InFace[face].push_back(number);
  this->ByPlace.emplace(face, place.X, place.Y, number);
  return number;
}

GridPoint PathNodes::PlaceOf(Id node, Id face) const
{
  if (node < this->NumberOfVertices)
  {
    const Id k = node == this->Mesh.Origin(3 * face) ? 0
      : node == this->Mesh.Origin(3 * face + 1)      ? 1
                                                     : 2;
    return { k == 1 ? GridPoint::One : 0, k == 2 ? GridPoint::One : 0 };
  }
  const Node& n = this->Nodes[node - this->NumberOfVertices];
  if (n.Edge == NoId)
  {
    return n.Place;
  }
  Id h = 3 * face;
  while (h < 3 * face + 2 && FindEdge(this->Mesh, h) != n.Edge)
  {
    ++h;
  }
  std::array<std::int64_t, 3> b{ { 0, 0, 0 } };
  const bool along = this->Mesh.Origin(h) == this->Mesh.Origin(n.Edge);
  b[(h + 1) % 3] = along ? n.T : GridPoint::One - n.T;
  b[h % 3] = GridPoint::One - b[(h + 1) % 3];
  return { b[1], b[2] };
}

bool PathNodes::AreOnOneSide(Id a, Id b, Id face, int& side) const
{
  for (side = 0; side < 3; ++side)
  {
    if (this->PositionOnSide(a, face, side) >= 0 && this->PositionOnSide(b, face, side) >= 0)
    {
      return true;
    }
  }
  return false;
}

/// Returns the position of a node on a side of a face, from 0 at its first corner; -1 if the node
/// is not on the side.
int PathNodes::PositionOnSide(Id node, Id face, int side) const
{
  const Id h = 3 * face + side;
  const Id edge = FindEdge(this->Mesh, h);
  const auto found = this->OnEdge.find(edge);
  const int count = found == this->OnEdge.end() ? 0 : static_cast<int>(found->second.size());
  if (node == this->Mesh.Origin(h))
  {
    return 0;
  }
  if (node == this->Mesh.Destination(h))
  {
    return count + 1;
  }
  if (node < this->NumberOfVertices || this->Nodes[node - this->NumberOfVertices].Edge != edge)
  {
    return -1;
  }
  // Ids increase along the edge.
  const auto place = std::lower_bound(found->second.begin(), found->second.end(), node);
  const int position = static_cast<int>(place - found->second.begin());
  return this->Mesh.Origin(edge) == this->Mesh.Origin(h) ? position + 1 : count - position;
}

Id PathNodes::FindNextOnSide(Id a, Id b, Id face, int side) const
{
  const int from = this->PositionOnSide(a, face, side);
  const int to = this->PositionOnSide(b, face, side);
  if (std::abs(from - to) <= 1)
  {
    return b;
  }
  const int position = from < to ? from + 1 : from - 1;
  const Id h = 3 * face + side;
  const Id edge = FindEdge(this->Mesh, h);
  const std::vector<Id>& nodes = this->OnEdge.find(edge)->second;
  const bool along = this->Mesh.Origin(edge) == this->Mesh.Origin(h);
  return nodes[along ? position - 1 : static_cast<int>(nodes.size()) - position];
}

double PathNodes::Measure(Id a, Id b, Id face) const
{
  int side = 0;
  if (this->AreOnOneSide(a, b, face, side))
  {
    // Bitwise identical in all faces of the edge.
    const Id edge = FindEdge(this->Mesh, 3 * face + side);
    auto mark = [&](Id node) {
      return node == this->Mesh.Origin(edge)   ? std::int64_t(0)
        : node == this->Mesh.Destination(edge) ? GridPoint::One
                                               : this->Nodes[node - this->NumberOfVertices].T;
    };
    const std::int64_t difference = std::abs(mark(a) - mark(b));
    return difference == GridPoint::One
      ? this->Mesh.Length(edge)
      : this->Mesh.Length(edge) * (static_cast<double>(difference) / GridPoint::One);
  }
  return DistanceInFace(this->Mesh, face, this->PlaceOf(std::min(a, b), face).GetBarycentric(),
    this->PlaceOf(std::max(a, b), face).GetBarycentric());
}

std::vector<SurfacePoint> PathNodes::MakePoints() const
{
  std::vector<SurfacePoint> points;
  points.reserve(this->NumberOfVertices + this->Nodes.size());
  for (Id v = 0; v < this->NumberOfVertices; ++v)
  {
    points.push_back(SurfacePoint::AtVertex(v));
  }
  for (const Node& node : this->Nodes)
  {
    if (node.Edge != NoId)
    {
      points.push_back(
        SurfacePoint::InsideEdge(node.Edge, static_cast<double>(node.T) / GridPoint::One));
      continue;
    }
    SurfacePoint point;
    point.On = SurfacePoint::Support::Face;
    point.Face = node.Face;
    point.Barycentric = node.Place.GetBarycentric();
    points.push_back(point);
  }
  return points;
}
}
