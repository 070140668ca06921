// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Dijkstra's algorithm in a graph. Internal.
#ifndef dggGraphDijkstra_h
#define dggGraphDijkstra_h

#include "dggHeap.h"         // for MinimumHeap
#include "dggSearchLabels.h" // for SearchLabels

#include <vector> // for the seeds

namespace dgg
{
/// Computes final labels from labels initialized by SearchLabels::Start(), nearest first. Returns
/// false if aborted.
bool RunDijkstra(const GraphView& graph, const std::vector<GraphSeed>& seeds,
  const ProgressCallback& progress, MinimumHeap& heap, SearchLabels& labels, SearchEffort& effort);
}

#endif
