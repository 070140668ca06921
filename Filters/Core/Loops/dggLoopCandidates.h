// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graph edges that close loops around the surface. Internal.
#ifndef dggLoopCandidates_h
#define dggLoopCandidates_h

#include "dggGraphSearch.h" // for SearchResult
#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for the candidates

namespace dgg
{
/// A loop from the source to the tail of an edge, over the edge, and back from its head.
struct LoopCandidate
{
  double Length;
  Id Tail;
  Offset Edge;
};

struct LoopCandidates
{
  std::vector<LoopCandidate> Narrow; ///< with kinks as small as those of graph paths
  std::vector<LoopCandidate>
    Wide; ///< with larger kinks, which a loop close to their vertices may have
};

/// Returns the loops that pass nearly straight through both ends of an edge. Most other loops
/// contract to the source. `result` comes from a search from one source with the given seeds.
LoopCandidates FindLoopCandidates(const SurfaceMesh& mesh, const GraphView& graph,
  const std::vector<GraphSeed>& seeds, const SearchResult& result);
}

#endif
