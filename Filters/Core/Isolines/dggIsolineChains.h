// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From pieces of isolines in faces to polylines. Internal.
#ifndef dggIsolineChains_h
#define dggIsolineChains_h

#include "dggIsolineParts.h" // for the pieces
#include "dggIsolines.h"     // for Isolines

#include <vector> // for the pieces

namespace dgg
{
/// Joins curves of faces where they share crossings, in order of levels, then curves. A line ends
/// at a crossing that is not shared by exactly two curves: on the boundary, and on edges with more
/// than two faces. It runs as the first one of its curves does. Lines that shrink to a point, by
/// snapping to a vertex, are left out. Fails when stopped; then there are no lines.
Status JoinFaceCurves(const SurfaceMesh& mesh, const std::vector<LevelCrossing>& crossings,
  const std::vector<FaceCurve>& curves, const ProgressCallback& progress, Isolines& lines);
}

#endif
