// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropagation.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <queue>

namespace dgg
{
namespace
{
constexpr Offset VerticesPerBlock = 65536;
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
}

/// Relaxes the two edges of the face at the origin of a half-edge. A path counts if it is shorter
/// than the distance before all edges were relaxed by more than rounding, so that the result does
/// not depend on the order.
template <bool High>
void Propagation<High>::CollectShortcutsFrom(
  Id h, const std::vector<float>& before, std::vector<PropagationShortcut>& found) const
{
  const Id f = SurfaceMesh::Face(h);
  const int k = h % 3;
  const PropagationFace& face = this->Faces[f];
  for (const int to : { NextOf(k), PreviousOf(k) })
  {
    const auto way = WayAlongEdge(f, face, k, to, this->Load(face.Corners[k]));
    if (way.Distance < (1.0F - PropagationRounding) * before[way.Vertex] &&
      way.Distance < this->Load(way.Vertex) && way.Distance <= this->Radius)
    {
      found.push_back(way);
    }
  }
}

/// Relaxes all mesh edges up to the radius, like Dijkstra's algorithm: no distance exceeds the
/// distance of a neighbor plus the edge length, up to rounding.
template <bool High>
Status Propagation<High>::RelaxEdges(const ParallelFor& parallel)
{
  std::vector<Id> lowered;
  bool isOver = false;
  if (this->Pieces)
  {
    DGG_RETURN_IF_ERROR(this->Pieces->ShareDistances(this->Distances.get(), lowered, isOver));
  }
  std::priority_queue<PropagationShortcut, std::vector<PropagationShortcut>, IsLater> queue;
  const auto push = [&queue](std::vector<PropagationShortcut>& found) {
    for (const PropagationShortcut& way : found)
    {
      queue.push(way);
    }
    found.clear();
  };
  std::vector<float> before(static_cast<std::size_t>(this->Mesh.GetNumberOfVertices()));
  ForRange(
    parallel, this->Mesh.GetNumberOfVertices(), VerticesPerBlock, [&](Offset begin, Offset end) {
      for (auto v = static_cast<Id>(begin); v < end; ++v)
      {
        before[v] = this->Load(v);
      }
    });
  std::mutex mutex;
  ForRange(parallel, this->Mesh.GetNumberOfFaces(), FacesPerBlock, [&](Offset begin, Offset end) {
    std::vector<PropagationShortcut> found;
    for (auto f = static_cast<Id>(begin); f < end; ++f)
    {
      const PropagationFace& face = this->Faces[f];
      const float a = this->Load(face.Corners[0]);
      const float b = this->Load(face.Corners[1]);
      const float c = this->Load(face.Corners[2]);
      // A single condition per face, which is rarely true.
      const float excess = std::max(std::abs(a - b) - face.Lengths[0],
        std::max(std::abs(b - c) - face.Lengths[1], std::abs(c - a) - face.Lengths[2]));
      if (excess > PropagationRounding * a && !this->Mesh.IsDropped(f) && this->IsHere(f))
      {
        this->CollectShortcutsFrom(3 * f, before, found);
        this->CollectShortcutsFrom(3 * f + 1, before, found);
        this->CollectShortcutsFrom(3 * f + 2, before, found);
      }
    }
    const std::lock_guard<std::mutex> lock(mutex);
    push(found);
  });
  std::vector<PropagationShortcut> found;
  const auto collectAround = [&](Id v) {
    for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
    {
      if (this->IsHere(SurfaceMesh::Face(*g)))
      {
        this->CollectShortcutsFrom(*g, before, found);
      }
    }
    push(found);
  };
  for (isOver = false; !isOver;)
  {
    while (!queue.empty())
    {
      const PropagationShortcut way = queue.top();
      queue.pop();
      if (way.Distance < this->Load(way.Vertex))
      {
        this->Distances[way.Vertex].store(way.Distance, std::memory_order_relaxed);
        this->Shortcuts.push_back(way);
        collectAround(way.Vertex);
      }
    }
    isOver = true;
    if (this->Pieces)
    {
      lowered.clear();
      DGG_RETURN_IF_ERROR(this->Pieces->ShareDistances(this->Distances.get(), lowered, isOver));
      std::for_each(lowered.begin(), lowered.end(), collectAround);
    }
  }
  return Status::Success();
}

template <bool High>
Status Propagation<High>::FindShortcuts(const ParallelFor& parallel)
{
  DGG_RETURN_IF_ERROR(this->RelaxEdges(parallel));
  if (this->WantsLabels)
  {
    // Keep the shortcuts that define vertex distances.
    std::vector<PropagationShortcut>& shortcuts = this->Shortcuts;
    const auto isBeaten = [&](const PropagationShortcut& way) {
      return way.Distance != this->Load(way.Vertex);
    };
    shortcuts.erase(std::remove_if(shortcuts.begin(), shortcuts.end(), isBeaten), shortcuts.end());
    std::sort(shortcuts.begin(), shortcuts.end(),
      [](const auto& a, const auto& b) { return IsLater()(b, a); });
  }
  return Status::Success();
}

template Status Propagation<false>::FindShortcuts(const ParallelFor& parallel);
template Status Propagation<true>::FindShortcuts(const ParallelFor& parallel);
}
