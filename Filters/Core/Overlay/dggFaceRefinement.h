// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Local refinement of the faces of a surface.
#ifndef dggFaceRefinement_h
#define dggFaceRefinement_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggSubMesh.h"    // for SubMesh

#include <limits> // for the most faces
#include <vector> // for faces

namespace dgg
{
/// Splits each of the given faces into four by the midpoints of its sides, `levels` times: into
/// 4^levels congruent triangles. Adjacent faces with one or two split sides are divided into two or
/// three parts, so that the surface is conforming (red-green refinement: Bank, Sherman and Weiser,
/// "Some refinement algorithms and data structures for regular local mesh refinement", 1983). To
/// avoid splitting these parts again on the next level, each level except the last also refines
/// surrounding rings of faces, one per remaining level.
///
/// New vertices are also inserted into paths, with their positions. Vertices keep their ids, and
/// faces their orientation; `parents` receives, per face, the face of the previous surface that
/// contains it. Surfaces must be refined before they are cut. Edges whose midpoint would be within
/// 2e-9, in barycentric coordinates, of a side of a face of the mesh are not split, since points
/// snap there.
///
/// Fails, leaving the surface unchanged, if a face does not exist, `levels` is negative, there
/// would be more than `mostFaces` faces or 2^31 - 1 half-edges, or when stopped.
DGG_CORE_EXPORT Status RefineFaces(const SurfaceMesh& mesh, const std::vector<Id>& faces,
  int levels, const ProgressCallback& progress, SubMesh& surface, std::vector<Id>& parents,
  Offset mostFaces = (std::numeric_limits<Id>::max)() / 3);
}

#endif
