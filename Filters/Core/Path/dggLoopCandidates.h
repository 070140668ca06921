// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Edges of the graph at which ways around the surface meet. Internal.
#ifndef dggLoopCandidates_h
#define dggLoopCandidates_h

#include "dggGraphSearch.h" // for SearchResult
#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for the candidates

namespace dgg
{
/// A way from the source to the tail of an edge, over it, and back from its head.
struct LoopCandidate
{
  double Length;
  Id Tail;
  Offset Edge;
};

/// All ways there and back that pass straight through both ends of an edge, up to the kinks that
/// paths in the graph have, in radians up to `kink`. The shortest first. `result` is that of a
/// search from one source, whose seeds it was given.
std::vector<LoopCandidate> FindLoopCandidates(const SurfaceMesh& mesh, const GraphView& graph,
  const std::vector<GraphSeed>& seeds, const SearchResult& result, double kink);

/// The widest kinks that paths in a graph have.
double WidestKinkOf(const GraphView& graph);
}

#endif
