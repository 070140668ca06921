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
/// A surface cut open: its faces are those of the surface that was cut, in the same order. A vertex
/// has one copy for each sector that the cuts leave of the faces around it; the first copy has the
/// id of the vertex, further ones follow after all vertices. Paths and Places are
/// empty.
struct CutSurface : RefinedSurface
{
  std::vector<Id> VertexOf; ///< per vertex, the one that it is a copy of
};

/// What happens to vertices with several fans of faces, where sheets touch, and no chain.
enum class PinchedVertices
{
  Stay, ///< they are as they were
  Split ///< they get a copy for each fan, as if a chain went through
};

/// Cut along chains of vertices, such as RefinedSurface::Paths. Fails when two consecutive vertices
/// are not neighbours.
DGG_CORE_EXPORT Status CutAlongChains(const RefinedSurface& surface,
  const std::vector<std::vector<Id>>& chains, CutSurface& cut,
  PinchedVertices pinched = PinchedVertices::Stay);
}

#endif
