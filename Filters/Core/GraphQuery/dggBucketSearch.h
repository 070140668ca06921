// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Label correcting in a graph, over fans of edges or over all of them. Internal.
#ifndef dggBucketSearch_h
#define dggBucketSearch_h

#include "dggBucketQueue.h"  // for BucketQueue
#include "dggGraphFans.h"    // for GraphFans
#include "dggSearchLabels.h" // for SearchLabels

namespace dgg
{
/// Make labels that have been started final. With fans (or null), a path first goes on only over
/// the fan of the edge on which it came; that leaves a few labels too large, so then all edges are
/// certified one after the other, and what is found wrong is mended over all edges. The result is
/// that of Dijkstra's algorithm, up to rounding. `width` is the bucket width of the queue. With
/// targets, the limit of the labels drops to the largest distance of a target. The cost is
/// proportional to the number of vertices within the limit. False when aborted.
bool RunBucketSearch(const GraphView& graph, const GraphFans* fans,
  const std::vector<GraphSeed>& seeds, double width, const ProgressCallback& progress,
  BucketQueue& queue, SearchLabels& labels, SearchEffort& effort);

/// Only the first part of that: labels over the fans, some of them too large. `order` receives the
/// vertices as they were taken from the queue, which is nearly by distance; a few more than once.
void RunAlongFans(const GraphView& graph, const GraphFans& fans,
  const std::vector<GraphSeed>& seeds, double width, BucketQueue& queue, SearchLabels& labels,
  std::vector<Id>& order);

/// Lower labels that are final already to what they are with more seeds: only vertices that are
/// nearer to these are looked at. `touched` receives them, a few more than once. The result is that
/// of a search from all seeds, up to rounding. False when aborted.
bool LowerLabels(const GraphView& graph, const GraphFans* fans, const std::vector<GraphSeed>& seeds,
  double width, const ProgressCallback& progress, BucketQueue& queue, SearchLabels& labels,
  std::vector<Id>& touched);

/// A good width of buckets: about the distance between neighbours. So small that few vertices are
/// taken from the queue twice, and so large that a bucket holds some vertices to look ahead to.
double ChooseBucketWidth(const GraphView& graph);
}

#endif
