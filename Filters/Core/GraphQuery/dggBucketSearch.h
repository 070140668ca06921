// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Searches in a graph: nearest first, or label-correcting over fans of edges or all edges.
/// Internal.
#ifndef dggBucketSearch_h
#define dggBucketSearch_h

#include "dggBucketQueue.h"  // for BucketQueue
#include "dggGraphFans.h"    // for GraphFans
#include "dggHeap.h"         // for MinimumHeap
#include "dggSearchLabels.h" // for SearchLabels

namespace dgg
{
/// Dijkstra's algorithm: computes final labels from labels initialized by SearchLabels::Start(),
/// nearest first. Returns false if aborted.
bool RunDijkstra(const GraphView& graph, const std::vector<GraphSeed>& seeds,
  const ProgressCallback& progress, MinimumHeap& heap, SearchLabels& labels, SearchEffort& effort);

/// Computes final labels from labels initialized by SearchLabels::Start(). With fans (or null for
/// none), a path first continues only over the fan of the edge by which the path arrived. This
/// restriction leaves a few labels too large. Therefore all edges are then certified one after the
/// other, and labels found too large are corrected over all edges. The result is that of Dijkstra's
/// algorithm. `width` is the bucket width of the queue. With targets, the limit of
/// the labels drops to the largest distance of a target. The cost is proportional to the number of
/// vertices within the limit. Returns false if aborted.
bool RunBucketSearch(const GraphView& graph, const GraphFans* fans,
  const std::vector<GraphSeed>& seeds, double width, const ProgressCallback& progress,
  BucketQueue& queue, SearchLabels& labels, SearchEffort& effort);

/// Runs only the first phase of RunBucketSearch(): computes labels over the fans, some of which are
/// too large. `order` receives the vertices as they were taken from the queue, nearly sorted by
/// distance; some vertices occur several times.
void RunAlongFans(const GraphView& graph, const GraphFans& fans,
  const std::vector<GraphSeed>& seeds, double width, BucketQueue& queue, SearchLabels& labels,
  std::vector<Id>& order);

/// Updates final labels after adding further seeds. Only vertices that are nearer to the new seeds
/// are visited. `touched` receives these vertices; some occur several times. The result is that of
/// a search from all seeds. Returns false if aborted.
bool LowerLabels(const GraphView& graph, const GraphFans* fans, const std::vector<GraphSeed>& seeds,
  double width, const ProgressCallback& progress, BucketQueue& queue, SearchLabels& labels,
  std::vector<Id>& touched);

/// Returns a suitable bucket width, about the distance between neighbors. The width is so small
/// that few vertices are taken from the queue twice, and so large that a bucket holds several
/// vertices to prefetch.
double ChooseBucketWidth(const GraphView& graph);
}

#endif
