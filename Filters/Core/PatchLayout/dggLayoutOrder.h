// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A layout of patches as a graph with an order of the edges around each landmark. Internal.
#ifndef dggLayoutOrder_h
#define dggLayoutOrder_h

#include "dggPatchBoundaries.h" // for PatchLayout
#include "dggSurfaceCut.h"      // for CutSurface

#include <array>  // for edges
#include <vector> // for lists

namespace dgg
{
/// The edges around a landmark, counter-clockwise.
struct EdgeOrder
{
  std::vector<Id> Edges;
  /// Whether the order is that of all edges of the landmark. Otherwise it grows as they are traced.
  bool IsKnown = false;
  /// Whether there is a gap between the last edge and the first: the order is a line.
  bool HasGap = false;

  EdgeOrder Reversed() const;
};

/// The edges of a layout, without repetition, and what is known of their order.
class LayoutOrder
{
public:
  /// Fails when a landmark is out of range, an edge joins a landmark with itself or occurs twice,
  /// a patch has fewer than three sides, or patches do not fit together along their sides.
  Status Read(const PatchLayout& layout, Id numberOfLandmarks);

  const std::vector<std::array<Id, 2>>& GetEdges() const { return this->Edges; }
  const std::vector<EdgeOrder>& GetOrders() const { return this->Orders; }
  /// The edge that joins two landmarks; NoId when there is none.
  Id FindEdge(Id a, Id b) const;

private:
  Status ReadPatches(const PatchLayout& layout, Id numberOfLandmarks);
  Status AddEdges(const PatchLayout& layout, Id numberOfLandmarks);
  void FindOrders(const PatchLayout& layout, Id numberOfLandmarks);

  std::vector<std::array<Id, 2>> Edges;
  std::vector<EdgeOrder> Orders; // per landmark
};

/// A corner of what lies between the curves: a sector of a landmark, from a curve
/// counter-clockwise to the next one; NoId is the boundary of the surface.
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
