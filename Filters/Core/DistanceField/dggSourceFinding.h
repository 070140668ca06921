// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual sources of exact distances, of those of graphs, and of any others.
#ifndef dggSourceFinding_h
#define dggSourceFinding_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggExactGeodesics.h" // for ExactResult
#include "dggGraphSearch.h"    // for SearchResult
#include "dggParallel.h"       // for ParallelFor
#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggVirtualSources.h" // for VirtualSources

#include <vector> // for the relays

namespace dgg
{
/// The virtual sources of exact distances: the pseudo-source from which the last straight piece of
/// the path to a vertex starts, or the one before where that explains more (MergeRelays()), as
/// behind flat vertices. `sources` are those of the run.
DGG_CORE_EXPORT void FindVirtualSources(const SurfaceMesh& mesh,
  const std::vector<GeodesicSource>& sources, const ExactResult& result, VirtualSources& found);

/// The virtual sources of the corrected distances of a search, with relays merged: for distances
/// inside of faces. Those of the search itself are for what is reached over further edges.
DGG_CORE_EXPORT void FindVirtualSources(
  const SurfaceMesh& mesh, const SearchResult& result, VirtualSources& found);

/// Find for each vertex the virtual source that explains the distances of its neighbours best:
/// its direction and the curvature of the wave that comes from there, which is one over its
/// distance. Neighbours whose distance comes another way hardly count. The field may be a foreign
/// one, from fast marching or heat; of the distance at a source nothing is assumed.
///
/// `distances` are per vertex; Infinity or NaN where unreached. Where there is nothing to fit, as
/// at a source or an Irregular vertex, the virtual source is the vertex itself. False when stopped;
/// then nothing is found.
DGG_CORE_EXPORT bool FitVirtualSources(const SurfaceMesh& mesh, const double* distances,
  const ParallelFor& parallel, VirtualSources& found,
  const ProgressCallback& progress = ProgressCallback());

/// The vertices that are reached, the nearest first.
DGG_CORE_EXPORT std::vector<Id> SortReached(const std::vector<double>& distances);

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
DGG_CORE_EXPORT void MergeRelays(const SurfaceMesh& mesh, const std::vector<double>& distances,
  const std::vector<Id>& order, const std::vector<Id>& relays, VirtualSources& sources);
}

#endif
