// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shortest path between two points in a graph. Internal.
#ifndef dggPointToPoint_h
#define dggPointToPoint_h

#include "dggBucketQueue.h"  // for BucketQueue
#include "dggGraphFans.h"    // for GraphFans
#include "dggGraphSearch.h"  // for GraphPath
#include "dggLandmarks.h"    // for Landmarks
#include "dggSearchLabels.h" // for WithLengths
#include "dggTurnLimits.h"   // for TurnLimits

#include <vector> // for the labels

namespace dgg
{
/// Data that accelerates a search between two points. All pointers may be null.
struct PathGuides
{
  const GraphFans* Fans = nullptr;
  const TurnLimits* Limits = nullptr; ///< only with fans
  const Landmarks* Marks = nullptr;
  const double* Positions = nullptr; ///< x y z per vertex
  double BucketWidth = 1.0;          ///< range of distances per bucket
};

/// A* search (Hart, Nilsson and Raphael 1968), directed to the goal by lower bounds of the
/// remaining distance. Vertices wait in buckets instead of a heap, so that some are expanded again
/// when their label drops. Buffers are reused between calls. The cost of a call depends on the
/// vertices between the points, not on the size of the graph.
class PointToPoint
{
public:
  explicit PointToPoint(Id numberOfVertices);

  /// Finds a shortest path. The path is empty, with length Infinity, if the two sets of seeds are
  /// not connected.
  void Run(const GraphView& graph, const PathGuides& guides, const std::vector<GraphSeed>& from,
    const std::vector<GraphSeed>& to, GraphPath& path);

private:
  struct alignas(32) Label
  {
    double ToGo = -Infinity; ///< lower bound of the remaining distance; -Infinity if not computed
    Offset Edge = -1;        ///< edge from the tail; -1 for a seed
    Id Tail = NoId;          ///< for a seed, its index
    float ArrivalAngle = -1.0f; ///< negative if undefined
    float ArrivalLength = 0.0f;
    Id Goal = NoId; ///< index of the goal seed at this vertex
  };

  void Forget();
  void Aim(const std::vector<GraphSeed>& to);
  double EstimateToGo(Id v) const;
  /// Lowers the label of a vertex. Returns the label, or null if the label leads to no shorter
  /// path.
  Label* Lower(Id v, double distance);
  void Start(const std::vector<GraphSeed>& from);
  template <typename Length>
  void Search(const GraphView& graph, const Length* lengths);
  template <typename Length>
  void Expand(const GraphView& graph, const Length* lengths, Id v);
  /// Prefetches the memory that EstimateToGo() and Expand() need.
  void PrefetchGuides(Id v) const;
  template <typename Length>
  void PrefetchEdges(const GraphView& graph, const Length* lengths, Id v) const;
  /// Returns the edge through which a path reaches a vertex that is not a seed; -1 if no row of the
  /// vertex leads back to a tail.
  template <typename Length>
  Offset FindEdgeTo(const GraphView& graph, const Length* lengths, Id v, Id& tail) const;
  template <typename Length>
  void CollectPath(const GraphView& graph, const Length* lengths,
    const std::vector<GraphSeed>& from, GraphPath& path);

  std::vector<double> Distances; ///< labels, stored separately: most are only compared
  std::vector<Label> Labels;
  std::vector<Id> Touched;
  std::vector<Offset> Shorter; ///< edges of a vertex that lower a label
  BucketQueue Queue;
  PathGuides Guides;
  const std::vector<GraphSeed>* To = nullptr;
  Landmarks::Goal MarksGoal;
  double Center[3] = {};     ///< center of the goal
  double CenterToGo = 0.0;   ///< lower bound of the distance from the center to the goal
  double SmallestToGo = 0.0; ///< lower bound everywhere
  double Best = Infinity;    ///< length of the shortest path so far
  Id End = NoId;             ///< last vertex of the shortest path so far
};
}

#endif
