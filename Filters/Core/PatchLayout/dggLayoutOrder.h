// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A layout of patches as a graph with an order of the edges around each landmark. Internal.
#ifndef dggLayoutOrder_h
#define dggLayoutOrder_h

#include "dggPatchBoundaries.h" // for PatchLayout
#include "dggSurfaceCut.h"      // for CutAlongChains

#include <array>  // for edges
#include <vector> // for lists

namespace dgg
{
/// The edges around a landmark, counter-clockwise.
struct EdgeOrder
{
  std::vector<Id> Edges;
  /// True if all edges of the landmark are ordered. Otherwise the order grows as edges are traced.
  bool IsKnown = false;
  /// True if there is a gap between the last edge and the first, so that the order is linear rather
  /// than cyclic.
  bool HasGap = false;

  EdgeOrder Reversed() const;
};

/// The edges of a layout, without repetition, and their order as far as it is known.
class LayoutOrder
{
public:
  /// Fails if a landmark is out of range, an edge joins a landmark with itself or occurs twice, a
  /// patch has fewer than three sides, or patches do not fit together along their sides.
  Status Read(const PatchLayout& layout, Id numberOfLandmarks);

  const std::vector<std::array<Id, 2>>& GetEdges() const { return this->Edges; }
  const std::vector<EdgeOrder>& GetOrders() const { return this->Orders; }
  /// Returns the edge that joins two landmarks; NoId if there is none.
  Id FindEdge(Id a, Id b) const;

private:
  Status ReadPatches(const PatchLayout& layout, Id numberOfLandmarks);
  Status AddEdges(const PatchLayout& layout, Id numberOfLandmarks);
  void FindOrders(const PatchLayout& layout, Id numberOfLandmarks);

  std::vector<std::array<Id, 2>> Edges;
  std::vector<EdgeOrder> Orders; // per landmark
};

/// A corner of a region between the curves: a sector of a landmark, from a curve counter-clockwise
/// to the next one; NoId is the boundary of the surface.
struct LayoutSector
{
  Id Landmark = NoId;
  Id Begin = NoId;
  Id End = NoId;
  bool IsWhole = false; ///< full turn: there is no curve at the landmark yet
  Id Vertex = NoId;     ///< vertex of the surface cut open
  Id Part = NoId;       ///< part into which the curves divide the surface
};

/// A surface with the part of a layout that has been drawn.
struct DrawnSurface
{
  /// Split at the landmarks (its first paths, single points), and along the curves (the remaining
  /// paths).
  SubMesh Refined;
  std::vector<Id> DrawnEdges; ///< edges of the layout, in the order of their curves
  std::vector<char> IsDrawn;  ///< per edge of the layout
  SubMesh Opened;             ///< cut open along all curves
  SurfaceMesh OpenedMesh;
};

/// Returns all sectors, without setting Part. `edges` are the layout edges, by their landmarks.
std::vector<LayoutSector> FindSectors(
  const DrawnSurface& surface, const std::vector<std::array<Id, 2>>& edges);

/// Returns the sectors of a landmark in which the order allows an edge.
std::vector<LayoutSector> FindAllowedSectors(const std::vector<LayoutSector>& sectors,
  const DrawnSurface& surface, Id landmark, const EdgeOrder& order, Id edge);

/// Inserts a new edge, in its sector at a landmark, among the edges drawn before.
void InsertIntoOrder(EdgeOrder& order, const LayoutSector& sector, Id edge);
}

#endif
