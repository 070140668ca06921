// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finer faces in a part of a surface.
#ifndef dggFaceRefinement_h
#define dggFaceRefinement_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggRefinedSurface.h" // for RefinedSurface

#include <limits> // for the most faces
#include <vector> // for faces

namespace dgg
{
/// Split each of the given faces into four by the middles of its sides, `levels` times: into
/// 4^levels parts of one size. Faces around them close the surface: those with one or two split
/// sides get two or three parts (red and green refinement: Bank, Sherman and Weiser, "Some
/// refinement algorithms and data structures for regular local mesh refinement", 1983). So that
/// none of these is split again by the next level, each level but the last takes rings of faces
/// around along, one for every level that follows.
///
/// Paths get the new vertices, too, and their places. Vertices keep their ids, and faces their
/// orientation; `parents` gets, per face, the one of the surface before that it is a part of.
/// Surfaces are refined before they are cut. Edges are left whole where the middle would come
/// within 2e-9, in barycentric coordinates, of a side of a face of the mesh, as points do there.
///
/// Fails, and leaves the surface as it was, when a face does not exist, `levels` is negative, or
/// there would be more than `mostFaces` faces, or 2^31 - 1 half-edges; when stopped as well.
DGG_CORE_EXPORT Status RefineFaces(const SurfaceMesh& mesh, const std::vector<Id>& faces,
  int levels, const ProgressCallback& progress, RefinedSurface& surface, std::vector<Id>& parents,
  Offset mostFaces = std::numeric_limits<Id>::max() / 3);
}

#endif
