// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The corners of what lies between curves of a layout. Internal.
#ifndef dggLayoutSectors_h
#define dggLayoutSectors_h

#include "dggLayoutOrder.h" // for EdgeOrder
#include "dggSurfaceCut.h"  // for CutSurface

#include <array>  // for edges
#include <vector> // for sectors

namespace dgg
{
/// A corner of what lies between the curves: a sector of a landmark, from a curve
/// counter-clockwise to the next one; NoId stands for the boundary of the surface.
struct LayoutSector
{
  Id Landmark = NoId;
  Id Begin = NoId;
  Id End = NoId;
  bool IsWhole = false; ///< goes all the way round: there is no curve yet
  Id Vertex = NoId;     ///< of the surface cut open
  Id Part = NoId;       ///< of the surface, as the curves divide it
};

/// A surface with what has been drawn of a layout on it.
struct DrawnSurface
{
  /// Split along the landmarks' single points, its first paths, and the curves, the others.
  RefinedSurface Refined;
  std::vector<Id> DrawnEdges; ///< of the layout, in the order of their curves
  std::vector<char> IsDrawn;  ///< per edge of the layout
  CutSurface Opened;          ///< cut open along all of them
  SurfaceMesh OpenedMesh;
};

/// All sectors, without Part. `edges` are those of the layout, by their landmarks.
std::vector<LayoutSector> FindSectors(
  const DrawnSurface& surface, const std::vector<std::array<Id, 2>>& edges);

/// The sectors of a landmark into which the order puts an edge.
std::vector<LayoutSector> FindAllowedSectors(const std::vector<LayoutSector>& sectors,
  const DrawnSurface& surface, Id landmark, const EdgeOrder& order, Id edge);

/// A new edge, in its sector at a landmark, among those that were drawn before.
void InsertIntoOrder(EdgeOrder& order, const LayoutSector& sector, Id edge);
}

#endif
