// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From pieces of the borders of Voronoi cells to curves. Internal.
#ifndef dggBorderCurves_h
#define dggBorderCurves_h

#include "dggFaceCells.h" // for BorderPiece
#include "dggVoronoi.h"   // for the diagram

#include <vector> // for the pieces

namespace dgg
{
/// Joins pieces between the same two cells to curves, as long as they are. A curve ends where
/// another cell is met, at the boundary of the surface, or where borders branch, which they do on
/// edges with more than two faces. Appends to the diagram; the result does not depend on the order
/// of the pieces.
void JoinBorderPieces(std::vector<BorderPiece>& pieces, VoronoiDiagram& diagram);
}

#endif
