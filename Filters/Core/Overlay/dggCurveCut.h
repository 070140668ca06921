// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surfaces cut open along curves, and the two sides of the curves.
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
  Id Face = NoId; ///< face on this side; NoId beyond the boundary, where all members are NoId
  Id From = NoId; ///< corner of the face at the start of the edge of the curve
  Id To = NoId;   ///< corner of the face at its end
};

/// The left and right sides of a curve, in its direction, as seen from the side of the surface from
/// which faces are counter-clockwise. Edge i of a curve goes from vertex i of its chain to vertex i
/// + 1; where the curve turns back on itself, left and right are swapped.
struct CurveSides
{
  std::vector<EdgeSide> Left;  ///< per edge
  std::vector<EdgeSide> Right; ///< per edge
};

/// A surface cut open along curves.
struct CurveCut
{
  CutSurface Surface;
  std::vector<CurveSides> Sides; ///< per path along which the surface was cut
};

/// Cuts a surface open along paths, either its own or others. A vertex of paths has one copy per
/// sector into which the paths divide the faces around it: one at the end of a path inside the
/// surface, two along it, four where two paths cross, one more per path at the boundary. A fan of
/// faces that touches a path in a single point gets a copy of its own there. A path of a single
/// edge inside the surface has no vertex with two copies; split the edge to get one.
///
/// Faces keep the orientation of the mesh, which is consistent where possible, so that left and
/// right are those of the first face of a component. Fails if an edge at a vertex of a path has
/// more than two faces, or two of opposite orientation, as on one-sided surfaces, because sides are
/// undefined there.
DGG_CORE_EXPORT Status CutAlongCurves(
  const RefinedSurface& surface, const std::vector<std::vector<Id>>& paths, CurveCut& cut);
/// Fails if CutAlongCurves() would fail for these paths.
DGG_CORE_EXPORT Status CheckSides(
  const RefinedSurface& surface, const std::vector<std::vector<Id>>& paths);
}

#endif
