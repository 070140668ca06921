// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Searches from several sources at once. Internal.
#ifndef dggManySources_h
#define dggManySources_h

#include "dggBucketQueue.h"   // for BucketQueue
#include "dggGeodesicGraph.h" // for GraphView
#include "dggGraphFans.h"     // for GraphFans
#include "dggLanes.h"         // for Lanes

#include <cstdint> // for the masks
#include <limits>  // for NotWaiting
#include <vector>  // for the vertices

namespace dgg
{
/// Distances from up to Lanes::Size sources, each on its own, in one search. Where their waves come
/// by at about the same time and from about the same direction, a vertex is taken from the queue
/// for all of them, and an edge is read once for all of them: this pays when the sources are close
/// together. All edges are certified once for all sources.
class ManySources
{
public:
  /// `fans` may be null: then all edges are looked at.
  ManySources(const GraphView& graph, const GraphFans* fans, double bucketWidth);

  /// `rows[k]` receives the distances from sources[k], Infinity beyond the radius.
  void Run(const Id* sources, int count, double radius, double* const* rows);

private:
  /// All that a search knows of a vertex.
  struct alignas(128) Vertex
  {
    Lanes Labels = Lanes::Unreached();
    float Arrivals[Lanes::Size]; ///< directions from which the labels came
    std::uint32_t New = 0;       ///< bits of the labels that are to be relaxed
    float Key = NotWaiting;      ///< under which it waits in the queue
  };
  static constexpr float NotWaiting = std::numeric_limits<float>::infinity();

  template <typename Length>
  void Propagate(const Length* lengths, const GraphFans* fans);
  template <typename Length>
  void Relax(const Length* lengths, const Lanes& labels, Offset edge);
  template <typename Length>
  void RelaxFans(const Length* lengths, const GraphFans& fans, Id v, std::uint32_t lanes);
  template <typename Length>
  void LookAhead(const Length* lengths, const GraphFans* fans, std::size_t i) const;
  template <typename Length>
  void Certify(const Length* lengths);

  const GraphView& Graph;
  const GraphFans* Fans;
  double BucketWidth;
  double Radius = Infinity;
  std::vector<Vertex> Vertices;
  BucketQueue Queue;
};
}

#endif
