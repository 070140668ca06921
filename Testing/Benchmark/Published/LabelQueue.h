// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The published label-correcting search in a graph, with the queues that were compared.
#ifndef LabelQueue_h
#define LabelQueue_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include <cstddef> // for std::size_t
#include <vector>  // for the labels

/// Position at which a vertex enters the queue, and choice of the vertex that leaves it (Bertsekas,
/// "A simple and fast label correcting algorithm for shortest paths", 1993).
enum class QueueRule
{
  FirstInFirstOut,
  SmallLabelFirst, ///< enters at the front if its label is at most the front label
  LargeLabelLast,  ///< labels above the mean of the queue are moved to the back
  SmallAndLarge    ///< both rules, as published
};

struct LabelResult
{
  std::vector<double> Distances; ///< per vertex; Infinity if unreached
  std::size_t Pops = 0;
  std::size_t Relaxations = 0;
  std::size_t Rotations = 0; ///< vertices moved from the front to the back
};

/// Returns the distances from a vertex. With a positive fan tolerance (radians), a vertex
/// propagates its label only along edges that deviate from the straight continuation by at most
/// this angle (Fang 2019, sec. 3.4, where the tolerance is arcsin sqrt(accuracy)). Labels can then
/// be too large, and vertices unreached. Unlike the published listing, vertices are not marked as
/// visited, because marks make the search incorrect.
LabelResult SearchByLabels(const dgg::GraphView& graph, const dgg::SurfaceMesh& mesh,
  dgg::Id source, QueueRule rule, double fanTolerance);

#endif
