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

struct LoopCandidates
{
  std::vector<LoopCandidate> Narrow; ///< with kinks no wider than those of paths in the graph
  std::vector<LoopCandidate> Wide;   ///< with others that a loop beside their vertices may have
};

/// The ways there and back that pass straight through both ends of an edge, but for kinks. Most
/// others contract to the source. `result` is that of a search from one source, whose seeds it was
/// given.
LoopCandidates FindLoopCandidates(const SurfaceMesh& mesh, const GraphView& graph,
  const std::vector<GraphSeed>& seeds, const SearchResult& result);
}

#endif
