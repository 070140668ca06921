// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Non-contractible closed geodesics.
#ifndef dggHandleLoops_h
#define dggHandleLoops_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggFoundLoop.h"  // for FoundLoop

#include <vector> // for the loops

namespace dgg
{
/// Finds closed geodesics of each component that are independent modulo 2: two for each handle, one
/// for each boundary loop but the last, one for each cross-cap. The geodesics result from
/// shortening the shortest loops of mesh edges through certain vertices. Components are sorted by
/// their smallest vertices, the loops of each component by length. A loop that cannot be moved,
/// because it has to pass through a vertex in which faces only touch, is represented by an empty
/// loop after the other loops of its component.
///
/// Fails if a component has a non-manifold edge. Returns no loops if stopped.
DGG_CORE_EXPORT Status FindHandleLoops(
  const SurfaceMesh& mesh, const ProgressCallback& progress, std::vector<FoundLoop>& loops);
}

#endif
