// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual sources of exact distances.
#ifndef dggExactSources_h
#define dggExactSources_h

#include "dggExactGeodesics.h" // for ExactResult
#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggVirtualSources.h" // for VirtualSources

#include <vector> // for the sources

namespace dgg
{
/// The virtual sources of exact distances: the pseudo-source from which the last straight piece of
/// the path to a vertex starts, or the one before where that explains more (MergeRelays()), as
/// behind flat vertices. `sources` are those of the run.
void FindVirtualSources(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const ExactResult& result, VirtualSources& found);
}

#endif
