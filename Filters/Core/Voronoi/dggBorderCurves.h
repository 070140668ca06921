// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds the borders between Voronoi cells. Internal.
#ifndef dggBorderCurves_h
#define dggBorderCurves_h

namespace dgg
{
struct VoronoiDiagram;

/// Adds maximal curves between the same two cells to a diagram whose polygons are complete. A curve
/// ends where another cell is adjacent, at the boundary of the surface, or where borders branch,
/// which they do on non-manifold edges. The result does not depend on the order of the polygons.
void AddBorderCurves(VoronoiDiagram& diagram);
}

#endif
