// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Keeps new paths away from curves. Internal.
#ifndef dggCurveMargin_h
#define dggCurveMargin_h

#include "dggSurfaceRefinement.h" // for SubMesh
#include "dggTypes.h"             // for Id

#include <vector> // for flags

namespace dgg
{
/// Removes a narrow margin along the curves along which a surface has been cut open, and around
/// single points, so that shortest paths on the rest keep a distance from them. The margin extends
/// over 0.3 of the edges that leave the vertices in question. Connectivity is preserved.
///
/// `isBlocked`, per vertex: keep away from the vertex. `isCut`, per half-edge: on a curve; at least
/// one of its ends is blocked. Vertices keep their ids; blocked ones lose their faces. Edges may
/// have at most two faces.
void RemoveMargin(const SurfaceMesh& oldMesh, const SubMesh& surface,
  const std::vector<char>& isBlocked, const std::vector<char>& isCut, SubMesh& rest);
}

#endif
