// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cuts a surface open along curves, and finds the two sides of the curves.
#ifndef dggSurfaceCut_h
#define dggSurfaceCut_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggSubMesh.h"    // for SubMesh

#include <vector> // for chains and sides

namespace dgg
{
/// Treatment of vertices with several fans of faces that are not on a chain.
enum class PinchedVertices
{
  Stay, ///< unchanged
  Split ///< one copy for each fan, as if a chain passed
};

/// Cuts a surface open along chains of vertices, such as SubMesh::Paths. The result
/// has the faces of the surface, in the same order. A vertex of a chain has one copy for each
/// sector of faces that the chains leave around it. The first copy has the id of the vertex,
/// further copies follow after all vertices. Fails if two consecutive vertices are not neighbors.
DGG_CORE_EXPORT Status CutAlongChains(const SubMesh& surface,
  const std::vector<std::vector<Id>>& chains, SubMesh& cut,
  PinchedVertices pinched = PinchedVertices::Stay);

/// One side of an edge of a curve.
struct EdgeSide
{
  Id Face = NoId; ///< on this side; beyond the boundary of the surface all members are NoId
  Id From = NoId; ///< the corner of the face where the edge of the curve starts
  Id To = NoId;   ///< the corner of the face where the edge of the curve ends
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
  SubMesh Surface;
  std::vector<CurveSides> Sides; ///< per path of the surface that was cut
};

/// Cuts a surface open along paths, either its own or others. A vertex of paths has one copy per
/// sector into which the paths divide the faces around it: one at the end of a path inside the
/// surface, two along it, four where two paths cross, one more per path at the boundary. A fan of
/// faces that touches a path in a single point gets a copy of its own there. A path of a single
/// edge inside the surface has no vertex with two copies; split the edge to get one.
///
/// Faces keep the orientation of the mesh, which is consistent where possible, so that the
/// first face of a component determines left and right. Fails if an edge at a vertex of a path has
/// more than two faces, or two of opposite orientation, as on one-sided surfaces, because sides are
/// undefined there.
DGG_CORE_EXPORT Status CutAlongCurves(
  const SubMesh& surface, const std::vector<std::vector<Id>>& paths, CurveCut& cut);
/// Fails if CutAlongCurves() would fail for these paths.
DGG_CORE_EXPORT Status CheckSides(
  const SubMesh& surface, const std::vector<std::vector<Id>>& paths);
}

#endif
