// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Simultaneous searches from several sources. Internal.
#ifndef dggManySources_h
#define dggManySources_h

#include "dggBucketQueue.h"   // for BucketQueue
#include "dggGeodesicGraph.h" // for GraphView
#include "dggGraphSearch.h"   // for GraphSeed
#include "dggLanes.h"         // for Lanes

#include <cstddef>    // for std::size_t
#include <functional> // for shouldContinue
#include <vector>     // for the vertices

namespace dgg
{
/// Order in which a search from several sources visits the vertices. Any order gives the same
/// distances; a good order converges quickly.
struct SweepOrder
{
  /// Vertices, approximately sorted by distance from a source in the middle of the group.
  std::vector<Id> Vertices;
  /// Number of leading vertices that are close to the sources: the sources reach these vertices in
  /// different orders.
  std::size_t NearField = 0;
};

/// Computes distances from up to Lanes::Size sources (each a set of seeds) in one search. Sources
/// close together reach the rest of the surface in about the same order. Therefore the vertices are
/// swept in the order in which one of the sources reaches them. Each vertex pulls the shortest path
/// from its neighbors, for all sources together and without a queue. Labels that remain too large
/// because a path runs against the order are found by certifying all edges, and corrected with a
/// queue.
class ManySources
{
public:
  ManySources(const GraphView& graph, double bucketWidth);

  using Sources = std::vector<const std::vector<GraphSeed>*>;

  /// Runs the search, and calls `shouldContinue` between phases. Returns false if `shouldContinue`
  /// returned false.
  bool Run(const Sources& sources, double radius, const SweepOrder& order,
    const std::function<bool()>& shouldContinue);

  /// Returns the distances of all vertices from source `k` (Infinity beyond the radius), and the
  /// vertices within the radius.
  void GetField(std::size_t k, std::vector<double>& field, std::vector<Id>& reached) const;

private:
  double Start(const Sources& sources);
  template <typename Length>
  void SweepNearField(const Length* lengths, const SweepOrder& order);
  template <typename Length>
  void Sweep(const Length* lengths, const std::vector<Id>& order);
  template <typename Length>
  void Certify(const Length* lengths);
  template <typename Length>
  void Mend(const Length* lengths);
  template <typename Length>
  Lanes Pull(const Length* lengths, Id v) const;
  template <typename Length>
  void Push(const Length* lengths, Id v);
  void Lower(Id v, const Lanes& labels);

  const GraphView& Graph;
  double BucketWidth;
  double Radius = Infinity;
  std::vector<Lanes> Labels; ///< per vertex
  std::vector<float> Keys;   ///< per vertex, its key in the queue
  BucketQueue Queue;
};
}

#endif
