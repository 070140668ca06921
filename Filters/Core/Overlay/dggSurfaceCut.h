// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cuts a surface open along edges.
#ifndef dggSurfaceCut_h
#define dggSurfaceCut_h

#include "dggCoreExport.h"        // for DGG_CORE_EXPORT
#include "dggSurfaceRefinement.h" // for RefinedSurface

#include <vector> // for chains and copies

namespace dgg
{
/// A surface cut open: its faces are those of the original surface, in the same order. A vertex has
/// one copy for each sector into which the cuts divide the faces around it; the first copy has the
/// id of the vertex, further copies follow after all vertices. Paths and Places are empty.
struct CutSurface : RefinedSurface
{
  std::vector<Id> VertexOf; ///< per vertex, the original vertex
};

/// Treatment of vertices with several fans of faces that are not on a chain.
enum class PinchedVertices
{
  Stay, ///< unchanged
  Split ///< one copy per fan, as if a chain passed through
};

/// Cuts along chains of vertices, such as RefinedSurface::Paths. Fails if two consecutive vertices
/// are not neighbors.
DGG_CORE_EXPORT Status CutAlongChains(const RefinedSurface& surface,
  const std::vector<std::vector<Id>>& chains, CutSurface& cut,
  PinchedVertices pinched = PinchedVertices::Stay);
}

#endif
