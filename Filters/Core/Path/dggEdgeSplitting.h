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
/// Split edges in the middle, and faces into two to four parts accordingly: the same surface with
/// more vertices. Paths get the new vertices, too. `isSplit`, per half-edge: one half of an edge is
/// enough. `parents` gets, per face, the one that it was a part of; may be null.
void SplitEdges(const SurfaceMesh& oldMesh, const std::vector<char>& isSplit,
  RefinedSurface& surface, std::vector<Id>* parents = nullptr);
}

#endif
