// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual sources beyond the last vertex that a way passes.
#ifndef dggRelays_h
#define dggRelays_h

#include "dggGraphSearch.h"    // for SearchResult
#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggVirtualSources.h" // for VirtualSources

#include <vector> // for the relays

namespace dgg
{
/// The vertices that are reached, the nearest first.
std::vector<Id> SortReached(const std::vector<double>& distances);

/// Lengthen virtual sources to those before them.
///
/// The last straight piece of a way to a vertex starts at its relay: a vertex at which the way
/// bends, or which it only passes. Ways over the relay reach no more than a narrow wedge behind it;
/// beside that, distances are those from the virtual source of the relay itself, which may explain
/// more of what is around the vertex. Along the rim of a hole the wedges are as narrow as the
/// pieces are short, and faces may be long.
///
/// Distances of neighbours decide. Where the model with the relay predicts too much, another wave
/// may be the nearer one; where that with the source before predicts too little, this source is not
/// visible. So it may miss little in exchange for what it explains.
///
/// `order` is that of the vertices, every relay before what lies behind it; `relays` has NoId where
/// the virtual source is a source. Takes as long as to look at all neighbours.
void MergeRelays(const SurfaceMesh& mesh, const std::vector<double>& distances,
  const std::vector<Id>& order, const std::vector<Id>& relays, VirtualSources& sources);

/// The virtual sources of the corrected distances of a search, with relays merged: for distances
/// inside of faces. Those of the search itself are for what is reached over further edges.
void FindVirtualSources(const SurfaceMesh& mesh, const SearchResult& result, VirtualSources& found);
}

#endif
