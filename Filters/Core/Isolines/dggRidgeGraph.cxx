// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggRidgeGraph.h"

#include <utility>

namespace dgg
{
Id RidgeGraph::AddNode(const SurfacePoint& point)
{
  if (IsVertex(point))
  {
    return this->AddVertex(point.Vertex);
  }
  this->Nodes.push_back(point);
  return static_cast<Id>(this->Nodes.size()) - 1;
}

Id RidgeGraph::AddVertex(Id v)
{
  if (this->NodeOfVertex[v] == NoId)
  {
    this->NodeOfVertex[v] = static_cast<Id>(this->Nodes.size());
    this->Nodes.push_back(SurfacePoint::AtVertex(v));
  }
  return this->NodeOfVertex[v];
}

void RidgeGraph::AddArc(Id from, Id to, Id face, double angle, std::vector<SurfacePoint> between)
{
  if (from != to || !between.empty())
  {
    this->Arcs.push_back({ from, to, face, angle, std::move(between) });
  }
}

void RidgeGraph::MakeLines(Ridges& ridges) const
{
  std::vector<Id> first(this->Nodes.size() + 1, 0);
  for (const Arc& arc : this->Arcs)
  {
    ++first[arc.From + 1];
    ++first[arc.To + 1];
  }
  for (std::size_t n = 0; n < this->Nodes.size(); ++n)
  {
    first[n + 1] += first[n];
  }
  std::vector<Id> arcsAt(2 * this->Arcs.size());
  std::vector<Id> filled(first.begin(), first.end() - 1);
  for (std::size_t a = 0; a < this->Arcs.size(); ++a)
  {
    arcsAt[filled[this->Arcs[a].From]++] = static_cast<Id>(a);
    arcsAt[filled[this->Arcs[a].To]++] = static_cast<Id>(a);
  }
  std::vector<bool> isUsed(this->Arcs.size(), false);
  const auto nodes = static_cast<Id>(this->Nodes.size());
  for (const bool isClosed : { false, true })
  {
    for (Id n = 0; n < nodes; ++n)
    {
      for (Id i = first[n]; i < first[n + 1] && (isClosed || first[n + 1] - first[n] != 2); ++i)
      {
        if (!isUsed[arcsAt[i]])
        {
          this->Follow(n, arcsAt[i], first, arcsAt, isUsed, ridges);
        }
      }
    }
  }
}

/// The line that leaves a node along an arc.
void RidgeGraph::Follow(Id node, Id arc, const std::vector<Id>& first,
  const std::vector<Id>& arcsAt, std::vector<bool>& isUsed, Ridges& ridges) const
{
  SurfacePath line;
  line.Points.push_back(this->Nodes[node]);
  double turned = 0.0;
  while (arc != NoId)
  {
    isUsed[arc] = true;
    const Arc& a = this->Arcs[arc];
    const bool isAlong = a.From == node;
    const double before = line.Length;
    const std::size_t count = a.Between.size();
    node = isAlong ? a.To : a.From;
    for (std::size_t i = 0; i <= count; ++i)
    {
      line.Points.push_back(i == count ? this->Nodes[node]
          : isAlong                    ? a.Between[i]
                                       : a.Between[count - 1 - i]);
      line.Faces.push_back(a.Face);
      const double length = MeasurePiece(this->Mesh, line, line.Faces.size() - 1);
      if (length == 0.0)
      {
        // The same point twice; the later one is the node.
        line.Points.erase(line.Points.end() - 2);
        line.Faces.pop_back();
      }
      line.Length += length;
    }
    turned += (line.Length - before) * a.Angle;
    arc = NoId;
    if (first[node + 1] - first[node] == 2)
    {
      const Id other =
        arcsAt[first[node]] == arcsAt[first[node] + 1] || !isUsed[arcsAt[first[node]]]
        ? arcsAt[first[node]]
        : arcsAt[first[node] + 1];
      arc = isUsed[other] ? NoId : other;
    }
  }
  if (line.Length > 0.0)
  {
    ridges.Angles.push_back(turned / line.Length);
    ridges.Lines.push_back(std::move(line));
  }
}
}
