// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Splits faces in four.
#ifndef dggFaceSubdivision_h
#define dggFaceSubdivision_h

#include "dggRefinedSurface.h" // for RefinedSurface

#include <cstdint> // for flags
#include <vector>  // for faces

namespace dgg
{
/// Halve all edges of the faces that are meant (one flag per face), and those of other faces that
/// are needed for the parts to fit: where any edge of a face is halved, so is its longest one. Each
/// face is split at the middle of its longest edge first, then its halves at those of the other
/// edges (Rivara, "Algorithms for refining triangular grids suitable for adaptive and multigrid
/// techniques", 1984). However often this is done, no angle becomes smaller than half of the
/// smallest one at first.
///
/// The surface is made of faces of `mesh`; old vertices keep their ids, and paths get the points
/// in between. Fails, and leaves the surface as it was, when there would be more than `mostFaces`
/// faces.
Status SubdivideFaces(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& isMeant,
  Offset mostFaces, RefinedSurface& surface);
}

#endif
