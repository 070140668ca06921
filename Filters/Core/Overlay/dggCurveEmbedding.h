// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes in which curves are chains of edges.
#ifndef dggCurveEmbedding_h
#define dggCurveEmbedding_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggRefinedSurface.h" // for RefinedSurface
#include "dggSurfaceCurve.h"   // for SurfaceCurve

#include <cstddef> // for std::size_t
#include <vector>  // for curves

namespace dgg
{
/// A curve as a chain of edges of a refined surface.
struct CurveChain
{
  /// The vertices that the curve runs through; each is a neighbour of the next. A closed curve ends
  /// with the vertex that it starts with, unless it is all in one place: then there is one vertex.
  std::vector<Id> Vertices;
  /// Per vertex, where it is among the given points, as SurfaceCurve::Parameters. Does not fall.
  /// Where given points follow each other in one place, that of the first.
  std::vector<double> Parameters;
  /// Per given point, its place among the vertices.
  std::vector<Offset> GivenPoints;
};

/// Split the faces of a mesh so that every curve is a chain of edges: RefineAlongPaths() with
/// crossings. Path i of the surface is curve i. Curves may share points, cross, run along edges of
/// the mesh or each other, and do so with themselves; whatever is within 1e-9, in barycentric
/// coordinates, becomes one vertex. A curve that has a single edge, which does not touch the
/// boundary, gets a vertex in its middle: cut open it would have no vertex with two sides. The
/// surface is the same one: each face lies in a face of the mesh and is oriented as that one, and
/// edges are split in all of their faces, however many they have.
DGG_CORE_EXPORT Status EmbedCurves(const SurfaceMesh& mesh, const std::vector<SurfaceCurve>& curves,
  const ProgressCallback& progress, RefinedSurface& surface);

/// A curve on the surface that EmbedCurves() made of several, or that was refined afterwards.
DGG_CORE_EXPORT CurveChain FollowCurve(
  const RefinedSurface& surface, const std::vector<SurfaceCurve>& curves, std::size_t number);
}

#endif
