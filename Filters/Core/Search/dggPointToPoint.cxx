// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPointToPoint.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
PointToPoint::PointToPoint(Id numberOfVertices)
  : Vertices(numberOfVertices)
{
}

double PointToPoint::Run(const GraphView& graph, const std::vector<GraphSeed>& from,
  const std::vector<GraphSeed>& to, const double* positions)
{
  this->Forget();
  this->Positions = positions;
  this->Best = Infinity;
  for (int side = 0; side < 2 && positions; ++side)
  {
    // The middle of the seeds. Any point would do: the distance to a point never changes by more
    // than the length of an edge, and this is all that a potential needs.
    const std::vector<GraphSeed>& seeds = side == 0 ? from : to;
    for (int k = 0; k < 3; ++k)
    {
      double sum = 0.0;
      for (const GraphSeed& seed : seeds)
      {
        sum += positions[3 * static_cast<std::size_t>(seed.Vertex) + k];
      }
      this->Centers[side][k] = sum / static_cast<double>(seeds.size());
    }
  }
  this->Start(0, from);
  this->Start(1, to);
  // Whatever has not been found yet is at least as long as the two smallest keys together. (The
  // potentials, opposite to each other, cancel out.) When one side is exhausted, its labels are
  // final, and so is the best meeting.
  while (!this->Heaps[0].IsEmpty() && !this->Heaps[1].IsEmpty() &&
    this->Heaps[0].Top().Key + this->Heaps[1].Top().Key < this->Best)
  {
    const int side = this->Heaps[0].Top().Key <= this->Heaps[1].Top().Key ? 0 : 1;
    WithLengths(graph, [&](const auto* lengths) { this->Expand(graph, lengths, side); });
  }
  return this->Best;
}

void PointToPoint::Forget()
{
  for (Id v : this->Touched)
  {
    this->Vertices[v] = Vertex();
  }
  this->Touched.clear();
  this->Heaps[0].Clear();
  this->Heaps[1].Clear();
}

void PointToPoint::Start(int side, const std::vector<GraphSeed>& seeds)
{
  for (const GraphSeed& seed : seeds)
  {
    if (seed.Distance < this->Vertices[seed.Vertex].Distance[side])
    {
      this->Lower(seed.Vertex, side, seed.Distance);
    }
  }
}

template <typename Length>
void PointToPoint::Expand(const GraphView& graph, const Length* lengths, int side)
{
  const MinimumHeap::Entry top = this->Heaps[side].Pop();
  const Vertex& vertex = this->Vertices[top.Vertex];
  const double label = vertex.Distance[side];
  const double potential = side == 0 ? vertex.Potential : -vertex.Potential;
  if (top.Key > label + potential) // a smaller label came later
  {
    return;
  }
  for (Offset e = graph.Offsets[top.Vertex]; e < graph.Offsets[top.Vertex + 1]; ++e)
  {
    const double distance = label + lengths[e];
    if (distance < this->Vertices[graph.Targets[e]].Distance[side])
    {
      this->Lower(graph.Targets[e], side, distance);
    }
  }
}

void PointToPoint::Lower(Id v, int side, double distance)
{
  Vertex& vertex = this->Vertices[v];
  if (vertex.Distance[0] == Infinity && vertex.Distance[1] == Infinity)
  {
    this->Touched.push_back(v);
    if (this->Positions)
    {
      const double* p = this->Positions + 3 * static_cast<std::size_t>(v);
      double lengths[2];
      for (int k = 0; k < 2; ++k)
      {
        const double* c = this->Centers[k];
        lengths[k] = std::sqrt((p[0] - c[0]) * (p[0] - c[0]) + (p[1] - c[1]) * (p[1] - c[1]) +
          (p[2] - c[2]) * (p[2] - c[2]));
      }
      vertex.Potential = 0.5 * (lengths[1] - lengths[0]);
    }
  }
  vertex.Distance[side] = distance;
  this->Best = std::min(this->Best, vertex.Distance[0] + vertex.Distance[1]);
  this->Heaps[side].Push(distance + (side == 0 ? vertex.Potential : -vertex.Potential), v);
}

std::size_t PointToPoint::GetMemorySize() const
{
  return this->Vertices.capacity() * sizeof(Vertex) + this->Touched.capacity() * sizeof(Id) +
    this->Heaps[0].GetMemorySize() + this->Heaps[1].GetMemorySize();
}
}
