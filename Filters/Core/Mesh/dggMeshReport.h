// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Defects and quality of a mesh, as counts.
#ifndef dggMeshReport_h
#define dggMeshReport_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <functional> // for vertices that are counted
#include <string>     // for warnings
#include <vector>     // for warnings

namespace dgg
{
/// Properties of a mesh that affect the reliability of computations on it.
struct MeshReport
{
  Offset Vertices = 0;
  Offset Faces = 0;
  Offset IsolatedVertices = 0; ///< vertices without a usable face
  Offset Components = 0;       ///< connected components with at least one face
  Offset BoundaryEdges = 0;
  Offset BoundaryLoops = 0;       ///< closed chains of boundary edges, per fan of pinched vertices
  Offset NonManifoldEdges = 0;    ///< edges with more than two faces
  Offset NonManifoldVertices = 0; ///< vertices with several fans, without non-manifold edges
  Offset RepeatedVertexFaces = 0; ///< faces that contain a vertex twice (dropped)
  Offset DegenerateFaces = 0;     ///< faces of zero area, up to rounding
  Offset DuplicateFaces = 0;      ///< faces on the vertices of an earlier one (dropped)
  Offset CoincidentPoints = 0;    ///< points with exactly the coordinates of an earlier one
  Offset InconsistentEdges = 0;   ///< manifold edges that cannot be oriented consistently
  Offset ReorientedFaces = 0;     ///< faces flipped to make the orientation consistent
  bool Orientable = true;
  /// Total genus over all components, with the fans of non-manifold vertices separated; -1 if a
  /// non-manifold edge exists or the mesh has no orientation.
  Offset Genus = 0;
  double Area = 0.0;             ///< of the non-degenerate faces
  double MeanAnisotropy = 0.0;   ///< see MeanAnisotropy
  double MedianAnisotropy = 0.0; ///< median of the same quantity over the faces
  double Mollification = 0.0;    ///< length added to the edges of degenerate faces
};

/// Numbers of defects of a surface that change its distances but do not prevent them.
struct SurfaceDefects
{
  Offset NonManifoldEdges = 0;
  Offset NonManifoldVertices = 0;
  Offset InconsistentEdges = 0;
  Offset DroppedCells = 0; ///< polygons with fewer than three distinct points
  Offset Fans = 0;         ///< polygons that cross or touch themselves
  Offset DuplicateFaces = 0;
};

/// Counts the non-manifold edges, non-manifold vertices and duplicate faces of which the vertex
/// with the smallest id is counted.
DGG_CORE_EXPORT SurfaceDefects CountDefects(
  const SurfaceMesh& mesh, const std::function<bool(Id vertex)>& isCounted);

/// Returns a warning for each kind of defects.
DGG_CORE_EXPORT std::vector<std::string> DescribeDefects(const SurfaceDefects& defects);

/// Mean elongation of triangles, l_max (l1+l2+l3) / (4 sqrt(3) area), over the non-degenerate
/// faces, weighted by area, so that slivers hardly count.
struct DGG_CORE_EXPORT MeanAnisotropy
{
  double Weighted = 0.0; ///< sum of elongation times area
  double Area = 0.0;

  void Add(const SurfaceMesh& mesh, Id f);
  void Add(const MeanAnisotropy& piece)
  {
    this->Weighted += piece.Weighted;
    this->Area += piece.Area;
  }
  /// Returns the mean; 1 for equilateral triangles, 0 if all faces are degenerate.
  double Get() const { return this->Area > 0.0 ? this->Weighted / this->Area : 0.0; }
};
/// Returns the MeanAnisotropy of all faces.
DGG_CORE_EXPORT MeanAnisotropy MeasureMeanAnisotropy(const SurfaceMesh& mesh);

/// Returns the number of points (x y z each) with exactly the coordinates of an earlier one. Points
/// with a non-finite coordinate are not counted.
DGG_CORE_EXPORT Offset CountCoincidentPoints(const double* points, Offset numberOfPoints);

/// Returns the properties of a mesh. `points` (x y z per vertex) may be null; coincident points are
/// then not counted.
DGG_CORE_EXPORT MeshReport InspectMesh(const SurfaceMesh& mesh, const double* points = nullptr);
}

#endif
