// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds the borders between Voronoi cells. Internal.
#ifndef dggBorderCurves_h
#define dggBorderCurves_h

#include <cstdint> // for layers

namespace dgg
{
struct VoronoiDiagram;

/// Adds maximal curves between the same two cells to a diagram whose polygons are complete. A curve
/// ends where another cell is adjacent, at the boundary of the surface, or where borders branch,
/// which they do on non-manifold edges. The result does not depend on the order of the polygons. If
/// `layers` are not null (DistanceField::Layers), polygons of layers 0 and 1 must be complete, and
/// segments between two faces belong to the piece of the face with the smaller index.
void AddBorderCurves(const std::uint8_t* layers, VoronoiDiagram& diagram);
}

#endif
