// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropagationShortcuts.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <queue>

namespace dgg
{
namespace
{
constexpr Offset FacesPerBlock = 4096;

/// A total order, so that the order of discovery is irrelevant.
struct IsLater
{
  bool operator()(const PropagationShortcut& a, const PropagationShortcut& b) const
  {
    if (a.Distance != b.Distance)
    {
      return a.Distance > b.Distance;
    }
    return a.Vertex != b.Vertex ? a.Vertex > b.Vertex : ComesBefore(b.Label, a.Label);
  }
};

class EdgeWays
{
public:
  EdgeWays(const SurfaceMesh& mesh, const PropagationFaces& faces, float radius,
    std::atomic<float>* distances)
    : Mesh(mesh)
    , Faces(faces)
    , Radius(radius)
    , Distances(distances)
  {
  }

  void CollectShortcuts(const ParallelFor& parallel);
  void Take(std::vector<PropagationShortcut>& shortcuts);

private:
  float Get(Id v) const { return this->Distances[v].load(std::memory_order_relaxed); }
  void CollectShortcutsFrom(Id h, std::vector<PropagationShortcut>& found) const;
  void Push(std::vector<PropagationShortcut>& found)
  {
    for (const PropagationShortcut& way : found)
    {
      this->Queue.push(way);
    }
    found.clear();
  }

  const SurfaceMesh& Mesh;
  const PropagationFaces& Faces;
  const float Radius;
  std::atomic<float>* const Distances;
  std::priority_queue<PropagationShortcut, std::vector<PropagationShortcut>, IsLater> Queue;
};

/// Relaxes the two edges of the face at the origin of a half-edge.
void EdgeWays::CollectShortcutsFrom(Id h, std::vector<PropagationShortcut>& found) const
{
  const Id f = SurfaceMesh::Face(h);
  const int k = h % 3;
  const PropagationFace& face = this->Faces[f];
  for (const int to : { NextOf(k), PreviousOf(k) })
  {
    const auto way = WayAlongEdge(f, face, k, to, this->Get(face.Corners[k]));
    const float known = this->Get(way.Vertex);
    if (way.Distance < (1.0F - PropagationRounding) * known && way.Distance <= this->Radius)
    {
      found.push_back(way);
    }
  }
}

void EdgeWays::CollectShortcuts(const ParallelFor& parallel)
{
  std::mutex mutex;
  ForRange(parallel, this->Mesh.GetNumberOfFaces(), FacesPerBlock, [&](Offset begin, Offset end) {
    std::vector<PropagationShortcut> found;
    for (auto f = static_cast<Id>(begin); f < end; ++f)
    {
      const PropagationFace& face = this->Faces[f];
      const float a = this->Get(face.Corners[0]);
      const float b = this->Get(face.Corners[1]);
      const float c = this->Get(face.Corners[2]);
      // A single condition per face, which is rarely true.
      const float excess = std::max(std::abs(a - b) - face.Lengths[0],
        std::max(std::abs(b - c) - face.Lengths[1], std::abs(c - a) - face.Lengths[2]));
      if (excess > PropagationRounding * a && !this->Mesh.IsDropped(f))
      {
        this->CollectShortcutsFrom(3 * f, found);
        this->CollectShortcutsFrom(3 * f + 1, found);
        this->CollectShortcutsFrom(3 * f + 2, found);
      }
    }
    const std::lock_guard<std::mutex> lock(mutex);
    this->Push(found);
  });
}

/// Applies shortcuts like Dijkstra's algorithm: each vertex is lowered once.
void EdgeWays::Take(std::vector<PropagationShortcut>& shortcuts)
{
  std::vector<PropagationShortcut> found;
  while (!this->Queue.empty())
  {
    const PropagationShortcut way = this->Queue.top();
    this->Queue.pop();
    if (way.Distance < this->Get(way.Vertex))
    {
      this->Distances[way.Vertex].store(way.Distance, std::memory_order_relaxed);
      shortcuts.push_back(way);
      for (const Id* g = this->Mesh.FanBegin(way.Vertex); g != this->Mesh.FanEnd(way.Vertex); ++g)
      {
        this->CollectShortcutsFrom(*g, found);
      }
      this->Push(found);
    }
  }
}
}

void TakeWaysAlongEdges(const SurfaceMesh& mesh, const PropagationFaces& faces, float radius,
  const ParallelFor& parallel, std::atomic<float>* distances,
  std::vector<PropagationShortcut>& shortcuts)
{
  EdgeWays ways(mesh, faces, radius, distances);
  ways.CollectShortcuts(parallel);
  ways.Take(shortcuts);
}

void KeepShortest(const std::atomic<float>* distances, std::vector<PropagationShortcut>& shortcuts)
{
  const auto isBeaten = [&](const PropagationShortcut& way) {
    return way.Distance != distances[way.Vertex].load(std::memory_order_relaxed);
  };
  shortcuts.erase(std::remove_if(shortcuts.begin(), shortcuts.end(), isBeaten), shortcuts.end());
  std::sort(shortcuts.begin(), shortcuts.end(),
    [](const auto& a, const auto& b) { return IsLater()(b, a); });
}
}
