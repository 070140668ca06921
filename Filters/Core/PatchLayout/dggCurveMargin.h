// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Keeps new paths away from curves. Internal.
#ifndef dggCurveMargin_h
#define dggCurveMargin_h

#include "dggSurfaceRefinement.h" // for RefinedSurface
#include "dggTypes.h"             // for Id

#include <vector> // for flags

namespace dgg
{
/// Take a narrow margin away from a surface that has been cut open along curves, and around single
/// points, so that a shortest path on what is left keeps clear of them. The margin ends at 0.3
/// of the edges that leave the vertices in question. What was connected stays connected.
///
/// `isBlocked`, per vertex: stay away from it. `isCut`, per half-edge: on a curve; at least one of
/// its ends is blocked. Vertices keep their ids; blocked ones lose their faces. Edges may
/// have two faces at most.
void RemoveMargin(const SurfaceMesh& oldMesh, const RefinedSurface& surface,
  const std::vector<char>& isBlocked, const std::vector<char>& isCut, RefinedSurface& rest);
}

#endif
