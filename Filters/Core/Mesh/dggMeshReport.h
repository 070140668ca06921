// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Defects and quality of a mesh, as counts.
#ifndef dggMeshReport_h
#define dggMeshReport_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h" // for SurfaceMesh

namespace dgg
{
/// What a careful user wants to know of a mesh before trusting a number computed on it.
struct MeshReport
{
  Offset Vertices = 0;
  Offset Faces = 0;
  Offset IsolatedVertices = 0; ///< vertices without a usable face
  Offset Components = 0;       ///< connected components with at least one face
  Offset BoundaryEdges = 0;
  Offset BoundaryLoops = 0; ///< closed chains of boundary edges, each fan of a pinched vertex apart
  Offset NonManifoldEdges = 0;    ///< edges with more than two faces
  Offset NonManifoldVertices = 0; ///< vertices with several fans that are on no non-manifold edge
  Offset RepeatedVertexFaces = 0; ///< faces that name a vertex twice (dropped)
  Offset DegenerateFaces = 0;     ///< faces of zero area, up to rounding
  Offset DuplicateFaces = 0;      ///< faces on the vertices of an earlier one (dropped)
  Offset CoincidentPoints = 0;    ///< points that have the very coordinates of an earlier one
  Offset InconsistentEdges = 0;   ///< manifold edges that no choice of orientation makes consistent
  Offset ReorientedFaces = 0;     ///< faces turned over to make orientation consistent
  bool Orientable = true;
  /// Total genus over all components, fans of non-manifold vertices apart; -1 when there is a
  /// non-manifold edge or no orientation.
  Offset Genus = 0;
  double MeanAnisotropy = 0.0; ///< as MeasureAnisotropy()
  double MedianAnisotropy = 0.0;
  double Mollification = 0.0; ///< length added to the edges of degenerate faces
};

/// How long triangles are: over the faces that are not degenerate, l_max (l1+l2+l3) / (4 sqrt(3)
/// area); 1 when equilateral. 0 when there is no such face.
struct Anisotropy
{
  double Mean = 0.0; ///< weighted with areas, so that slivers hardly count
  double Median = 0.0;
};

DGG_CORE_EXPORT Anisotropy MeasureAnisotropy(const SurfaceMesh& mesh);

/// How many points (x y z each) have the very coordinates of an earlier one. Those with a
/// coordinate that is not finite have not.
DGG_CORE_EXPORT Offset CountCoincidentPoints(const double* points, Offset numberOfPoints);

/// Inspect a mesh. `points` (x y z per vertex) may be null; coincident points are counted only with
/// it.
DGG_CORE_EXPORT MeshReport InspectMesh(const SurfaceMesh& mesh, const double* points = nullptr);
}

#endif
