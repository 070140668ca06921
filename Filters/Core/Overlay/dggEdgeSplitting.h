// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Splits edges of a refined surface in the middle. Internal.
#ifndef dggEdgeSplitting_h
#define dggEdgeSplitting_h

#include "dggRefinedSurface.h" // for RefinedSurface

#include <vector> // for flags

namespace dgg
{
/// Whether the middle of an edge is a point of its own: at least 2e-9, in barycentric coordinates,
/// from sides of faces of the old mesh, unless the edge lies there.
bool HasMiddle(const SurfaceMesh& oldMesh, const RefinedSurface& surface, Id halfEdge);

/// Split edges in the middle, and faces into two to four parts accordingly: the same surface with
/// more vertices. Paths get the new vertices, too. `isSplit`, per half-edge: one half of an edge is
/// enough. Edges must have a middle. `parents` gets, per face, the one that it was a part of; may
/// be null.
void SplitEdges(const SurfaceMesh& oldMesh, const std::vector<char>& isSplit,
  RefinedSurface& surface, std::vector<Id>* parents = nullptr);
}

#endif
