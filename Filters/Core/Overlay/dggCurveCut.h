// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surfaces cut open along curves, and the two sides of these.
#ifndef dggCurveCut_h
#define dggCurveCut_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggSurfaceCut.h" // for CutSurface

#include <cstddef> // for std::size_t
#include <vector>  // for sides

namespace dgg
{
/// One side of an edge of a curve.
struct EdgeSide
{
  Id Face = NoId; ///< on this side; NoId beyond the boundary of the surface, where all is NoId
  Id From = NoId; ///< the corner of the face where the edge of the curve starts
  Id To = NoId;   ///< and where it ends
};

/// The sides of a curve: that of its left hand and that of its right hand as one walks along it on
/// the side of the surface from which faces are seen counter-clockwise. Edge i of a curve goes from
/// vertex i of its chain to vertex i + 1; where the curve turns back on itself, left and right
/// change places.
struct CurveSides
{
  std::vector<EdgeSide> Left;  ///< per edge
  std::vector<EdgeSide> Right; ///< per edge
};

/// A surface cut open along curves.
struct CurveCut
{
  CutSurface Surface;
  std::vector<CurveSides> Sides; ///< per path of the surface that was cut
};

/// Cut a surface open along paths, its own or others. A vertex of paths has one copy per sector
/// that they leave of the faces around it: one at the end of a path inside the surface, two along
/// it, four where two paths cross, one more per path at the boundary. A sheet that touches a path
/// in a single point gets a copy of its own there. A path of a single edge inside the surface has
/// no vertex with two copies: split the edge to have one.
///
/// Faces are oriented as the mesh has them, which makes them consistent where it can, so that left
/// and right are those of the first face of a component. Fails when an edge at a vertex of a path
/// has more than two faces, or two of opposite orientation, as on one-sided surfaces: there would
/// be no sides.
DGG_CORE_EXPORT Status CutAlongCurves(
  const RefinedSurface& surface, const std::vector<std::vector<Id>>& paths, CurveCut& cut);
/// Whether one can cut along paths: what CutAlongCurves() fails for.
DGG_CORE_EXPORT Status CheckSides(
  const RefinedSurface& surface, const std::vector<std::vector<Id>>& paths);
}

#endif
