// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Lower bounds of graph distances, from the distances of some landmarks. Internal.
#ifndef dggLandmarks_h
#define dggLandmarks_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggGraphSearch.h"   // for GraphSeed
#include "dggPrefetch.h"      // for Prefetch

#include <array>   // for the codes
#include <cstddef> // for std::size_t
#include <cstdint> // for the codes
#include <vector>  // for the vertices

namespace dgg
{
class FarthestPoints;

/// Landmarks and the distances of all vertices from them. By the triangle inequality the distance
/// between two vertices is at least the difference between their distances from a landmark
/// (Goldberg and Harrelson, "Computing the shortest path: A* search meets graph theory", 2005).
/// Landmarks are vertices far from each other, at the tips of the surface. Their distances are
/// rounded to small integers, so that the distances of one vertex fill one cache line.
class Landmarks
{
public:
  static constexpr int Count = 32;

  /// Chooses landmarks by farthest-point sampling in the larger components. `mesh` is the mesh of
  /// the graph, or null if the graph has no angles. Must be called before all other functions.
  /// After an abort the object must not be used.
  Status Choose(const GraphView& graph, const SurfaceMesh* mesh, const ProgressCallback& progress);

  /// Returns at most Count landmarks; none if the graph has no edges.
  const std::vector<Id>& GetVertices() const { return this->Vertices; }

  /// Stores the distances of all vertices from landmark k. Must be called once for each landmark,
  /// in any order. Several threads may call SetDistances() simultaneously.
  void SetDistances(std::size_t k, const double* distances);

  /// Returns true if a path between two vertices exists.
  bool AreConnected(Id a, Id b) const { return this->Components[a] == this->Components[b]; }

  /// Goal of a search, the nearest of some seeds, as bounds of the seeds' distances from each
  /// landmark.
  struct Goal
  {
    alignas(64) std::array<std::int16_t, Count> Low;
    alignas(64) std::array<std::int16_t, Count> High;
  };
  void Aim(const std::vector<GraphSeed>& seeds, Goal& goal) const;

  /// Returns a lower bound of the distance of a vertex from the nearest seed of the goal, including
  /// the initial distance of the seed; -Infinity if the landmarks give no bound. The vertex must be
  /// connected with the goal.
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

  /// Prefetches a vertex.
  void PrefetchVertex(Id v) const { Prefetch(&this->Codes[v]); }

private:
  struct alignas(64) VertexCodes : std::array<std::int16_t, Count>
  {
  };

  std::vector<Id> ChooseComponents(const GraphView& graph);
  Status ChooseFrom(FarthestPoints& field, const GraphView& graph, const std::vector<Id>& starts,
    const ProgressCallback& progress);

  std::vector<Id> Vertices;
  std::vector<Id> Components;     ///< per vertex
  std::vector<VertexCodes> Codes; ///< per vertex, distances from all landmarks, rounded down
  double Step = 1.0;              ///< distance per unit of a code
};
}

#endif
