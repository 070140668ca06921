// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Closed geodesics that cannot be contracted.
#ifndef dggHandleLoops_h
#define dggHandleLoops_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggFoundLoop.h"  // for FoundLoop

#include <cstddef> // for std::size_t
#include <vector>  // for the loops

namespace dgg
{
/// Closed geodesics, independent of each other modulo 2, of each component: two for each handle,
/// one for each boundary but the last, one for each cross-cap. They are pulled tight from the
/// shortest loops of mesh edges through some vertices. Components come by their smallest vertices,
/// the loops of each the shortest first. A loop that cannot be moved, as it has to pass through a
/// vertex in which faces meet in nothing else, is an empty one after the others of its component.
///
/// Fails when a component has a non-manifold edge. No loops when it is stopped. `steps`, if given,
/// receives the number of vertices, faces and half-edges that were looked at, again and again: for
/// each component a multiple of its size.
DGG_CORE_EXPORT Status FindHandleLoops(const SurfaceMesh& mesh, const ProgressCallback& progress,
  std::vector<FoundLoop>& loops, std::size_t* steps = nullptr);
}

#endif
