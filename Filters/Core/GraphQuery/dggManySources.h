// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Searches from several sources at once. Internal.
#ifndef dggManySources_h
#define dggManySources_h

#include "dggBucketQueue.h"   // for BucketQueue
#include "dggGeodesicGraph.h" // for GraphView
#include "dggGraphSearch.h"   // for GraphSeed
#include "dggLanes.h"         // for Lanes

#include <cstddef>    // for std::size_t
#include <functional> // for the question whether to go on
#include <vector>     // for the vertices

namespace dgg
{
/// The order in which a search from several sources goes over the vertices. Any order gives the
/// same distances; a good one gives them soon.
struct SweepOrder
{
  /// By distance from a source in the middle of the others, about.
  std::vector<Id> Vertices;
  /// So many of them are so close to the sources that each source sees them in another order.
  std::size_t NearField = 0;
};

/// Distances from up to Lanes::Size sources, each a set of seeds, in one search. Sources close
/// together see the rest of the surface in about the same order. So the vertices are swept in the
/// order in which one of the sources reaches them, each pulling the shortest way from its
/// neighbours, for all sources in one go and without a queue. What that leaves too large, because a
/// way goes against the order, is found by certifying all edges, and mended with a queue.
class ManySources
{
public:
  ManySources(const GraphView& graph, double bucketWidth);

  using Sources = std::vector<const std::vector<GraphSeed>*>;

  /// `goes` is asked between parts of the work whether to go on. Returns false when it was stopped.
  bool Run(const Sources& sources, double radius, const SweepOrder& order,
    const std::function<bool()>& goes);

  /// The distances of all vertices from source `k`, Infinity beyond the radius, and the vertices
  /// within it.
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
  std::vector<float> Keys;   ///< per vertex, under which it waits in the queue
  BucketQueue Queue;
};
}

#endif
