// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The published search in a graph: label correcting, with the queues that it was compared with.
#ifndef LabelQueue_h
#define LabelQueue_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include <cstddef> // for std::size_t
#include <vector>  // for the labels

/// Where a vertex enters the queue, and which one leaves it (Bertsekas, "A simple and fast label
/// correcting algorithm for shortest paths", 1993).
enum class QueueRule
{
  FirstInFirstOut,
  SmallLabelFirst, ///< enters at the front when its label is not larger than that there
  LargeLabelLast,  ///< labels above the mean of the queue are moved to the back
  SmallAndLarge    ///< both, as published
};

struct LabelResult
{
  std::vector<double> Distances; ///< per vertex; Infinity if unreached
  std::size_t Pops = 0;
  std::size_t Relaxations = 0;
  std::size_t Rotations = 0; ///< vertices moved from the front to the back
};

/// Distances from a vertex. With a positive fan tolerance, radians, a vertex passes a label on only
/// along edges that deviate by no more than that from straight on (Fang 2019, sec. 3.4, where it is
/// arcsin sqrt(accuracy)): labels can then be too large, and vertices unreached. There are no marks
/// of visited vertices, as the published listing has them: with these it is wrong.
LabelResult SearchByLabels(const dgg::GraphView& graph, const dgg::SurfaceMesh& mesh,
  dgg::Id source, QueueRule rule, double fanTolerance);

#endif
