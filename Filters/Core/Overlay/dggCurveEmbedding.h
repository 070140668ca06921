// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Embeds curves into meshes as chains of edges.
#ifndef dggCurveEmbedding_h
#define dggCurveEmbedding_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggSubMesh.h"      // for SubMesh
#include "dggSurfaceCurve.h" // for SurfaceCurve

#include <cstddef> // for std::size_t
#include <vector>  // for curves

namespace dgg
{
/// A curve as a chain of edges of a refined surface.
struct CurveChain
{
  /// The vertices of the curve; consecutive vertices are neighbors. A closed curve repeats its
  /// first vertex at the end, unless it degenerates to one point: then there is one vertex.
  std::vector<Id> Vertices;
  /// Per vertex, its parameter as in SurfaceCurve::Parameters; non-decreasing. Coincident
  /// consecutive given points have the parameter of the first.
  std::vector<double> Parameters;
  /// Per given point, its index in Vertices.
  std::vector<Offset> GivenPoints;
};

/// Splits the faces of a mesh so that every curve is a chain of edges: RefineAlongPaths() with
/// crossings. Path i of the surface is curve i. Curves may share points, cross, run along edges of
/// the mesh or each other, and intersect themselves; points within 1e-9, in barycentric
/// coordinates, become one vertex. A curve with a single edge that does not touch the boundary gets
/// a vertex in its middle, because otherwise it would have no vertex with two sides when cut open.
/// The surface is unchanged: each face lies in a face of the mesh and has its orientation, and
/// edges are split in all of their faces, including non-manifold edges.
DGG_CORE_EXPORT Status EmbedCurves(const SurfaceMesh& mesh, const std::vector<SurfaceCurve>& curves,
  const ProgressCallback& progress, SubMesh& surface);

/// Returns the chain of curve `number` on the surface that EmbedCurves() made of `curves`, possibly
/// refined afterwards.
DGG_CORE_EXPORT CurveChain FollowCurve(
  const SubMesh& surface, const std::vector<SurfaceCurve>& curves, std::size_t number);
}

#endif
