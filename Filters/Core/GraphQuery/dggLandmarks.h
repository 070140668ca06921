// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lower bounds of distances in a graph from the distances of some landmarks. Internal.
#ifndef dggLandmarks_h
#define dggLandmarks_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggGraphFans.h"     // for GraphFans
#include "dggGraphSearch.h"   // for GraphSeed
#include "dggPrefetch.h"      // for Prefetch

#include <array>   // for the codes
#include <cstddef> // for std::size_t
#include <cstdint> // for the codes
#include <vector>  // for the vertices

namespace dgg
{
/// By the triangle inequality two vertices are at least as far apart as their distances from a
/// landmark differ (Goldberg and Harrelson, "Computing the shortest path: A* search meets graph
/// theory", 2005). Landmarks are vertices far from each other, at the tips of the surface. Their
/// distances are rounded to small integers, so that those of one vertex fill one cache line.
class Landmarks
{
public:
  static constexpr int Count = 32;

  /// Choose landmarks, farthest from all before first, in the larger components. To be called
  /// before anything else; good for nothing when it is aborted.
  Status Choose(const GraphView& graph, const GraphFans* fans, double bucketWidth,
    const ProgressCallback& progress);

  /// At most Count; none where there is no edge.
  const std::vector<Id>& GetVertices() const { return this->Vertices; }

  /// Distances of all vertices from landmark k. To be called once for each, in any order, also by
  /// several threads at once.
  void SetDistances(std::size_t k, const double* distances);

  /// Whether there is a way.
  bool AreConnected(Id a, Id b) const { return this->Components[a] == this->Components[b]; }

  /// What a search looks for: the nearest of some seeds.
  struct Goal
  {
    alignas(64) std::array<std::int16_t, Count> Low;
    alignas(64) std::array<std::int16_t, Count> High;
  };
  void Aim(const std::vector<GraphSeed>& seeds, Goal& goal) const;

  /// A lower bound of the distance of a vertex from the nearest seed of the goal, with that which
  /// the seed starts with; -Infinity when nothing is known. The vertex is connected with the goal.
  double Bound(Id v, const Goal& goal) const
  {
    const std::int16_t* codes = this->Codes[v].data();
    std::int16_t largest = 0;
    for (int k = 0; k < Count; ++k)
    {
      const auto below = static_cast<std::int16_t>(goal.Low[k] - codes[k]);
      const auto above = static_cast<std::int16_t>(codes[k] - goal.High[k]);
      const std::int16_t larger = below > above ? below : above;
      largest = largest > larger ? largest : larger;
    }
    return largest > 0 ? largest * this->Step : -Infinity;
  }

  /// Ask for the memory of a vertex.
  void PrefetchVertex(Id v) const { Prefetch(&this->Codes[v]); }

private:
  struct alignas(64) VertexCodes : std::array<std::int16_t, Count>
  {
  };

  std::vector<Id> ChooseComponents(const GraphView& graph);
  bool ChooseFrom(const GraphView& graph, const GraphFans* fans, double bucketWidth,
    const std::vector<Id>& starts, const ProgressCallback& progress);

  std::vector<Id> Vertices;
  std::vector<Id> Components;     ///< of each vertex
  std::vector<VertexCodes> Codes; ///< of each vertex: distances from all landmarks, rounded down
  double Step = 1.0;              ///< length of 1
};
}

#endif
