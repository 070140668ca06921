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

#include <vector> // for the sources

namespace dgg
{
/// The virtual sources of exact distances: the pseudo-source from which the last straight piece of
/// the path to a vertex starts, or the one before where that explains more, as behind flat
/// vertices. `sources` are those of the run.
DGG_CORE_EXPORT void FindVirtualSources(const SurfaceMesh& mesh,
  const std::vector<GeodesicSource>& sources, const ExactResult& result, VirtualSources& found,
  const ParallelFor& parallel = ParallelFor());

/// Finds the virtual sources of a search, with relays merged, for distances inside faces. Offset
/// plus length equals `distances`, which are the labels or the corrected distances of the result.
/// The virtual sources of the result are for vertices reached over further edges.
DGG_CORE_EXPORT void FindVirtualSources(const SurfaceMesh& mesh, const SearchResult& result,
  const std::vector<double>& distances, VirtualSources& found,
  const ParallelFor& parallel = ParallelFor());

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
}

#endif
