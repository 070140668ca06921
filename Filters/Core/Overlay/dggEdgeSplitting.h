// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Splits edges of a refined surface at their midpoints. Internal.
#ifndef dggEdgeSplitting_h
#define dggEdgeSplitting_h

#include "dggSubMesh.h" // for SubMesh

#include <vector> // for flags

namespace dgg
{
/// Returns true if the midpoint of an edge is a distinct point: at least 2e-9, in barycentric
/// coordinates, from the sides of faces of the old mesh, unless the edge lies on such a side.
bool HasMiddle(const SurfaceMesh& oldMesh, const SubMesh& surface, Id halfEdge);

/// Splits edges at their midpoints, and faces into two to four parts accordingly. New vertices are
/// also inserted into paths. `isSplit` is per half-edge; one half-edge of an edge is sufficient.
/// Edges must have a midpoint (HasMiddle()). `parents` receives, per face, the face that contains
/// it; may be null.
void SplitEdges(const SurfaceMesh& oldMesh, const std::vector<char>& isSplit, SubMesh& surface,
  std::vector<Id>* parents = nullptr);
}

#endif
