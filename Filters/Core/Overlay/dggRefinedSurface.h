// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A refined mesh, and the mapping to its parent mesh.
#ifndef dggRefinedSurface_h
#define dggRefinedSurface_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h"  // for SurfaceMesh
#include "dggSurfacePath.h"  // for SurfacePath
#include "dggSurfacePoint.h" // for SurfacePoint

#include <array>  // for barycentric coordinates
#include <vector> // for the arrays

namespace dgg
{
/// A mesh whose faces have been split: the same surface with more vertices. Dropped faces of the
/// old mesh are omitted.
struct DGG_CORE_EXPORT RefinedSurface
{
  /// The vertices as points of the old mesh: first its own vertices, with their ids, then new ones.
  std::vector<SurfacePoint> Points;
  std::vector<Id> Triangles;   ///< 3 vertices per face, oriented as in the old mesh
  std::vector<double> Lengths; ///< per half-edge 3f+k, from corner k to corner k+1 of face f
  std::vector<Id> Twins;       ///< per half-edge, as SurfaceMesh::Twin()
  std::vector<Id> Faces;       ///< per face, the old face that contains it
  /// Per path, its vertices; consecutive vertices are neighbors.
  std::vector<std::vector<Id>> Paths;
  /// Per path, the parameters of its vertices: the index of the path segment plus the fraction
  /// within the segment. Vertex i + 1 is in the same segment as vertex i, or at its end. If both
  /// ends of short segments became one vertex, it has the parameter of the first.
  std::vector<std::vector<double>> Places;

  Id GetNumberOfVertices() const { return static_cast<Id>(this->Points.size()); }
  Id GetNumberOfFaces() const { return static_cast<Id>(this->Faces.size()); }
  Id GetNumberOfHalfEdges() const { return static_cast<Id>(this->Triangles.size()); }
  Id Origin(Id h) const { return this->Triangles[h]; }
  Id Destination(Id h) const { return this->Triangles[SurfaceMesh::Next(h)]; }
  Id Twin(Id h) const { return this->Twins[h]; }

  /// Computes Twins: half-edges belong to one edge if they have the same ends and the same place, a
  /// number that identifies an edge or a face of the previous surface.
  void Glue(const std::vector<Offset>& places);
  /// Builds the mesh with these faces and lengths, so that its metric is that of the old mesh.
  /// Parts of degenerate faces of the old mesh are degenerate as well.
  Status Build(const SurfaceMesh& oldMesh, SurfaceMesh& mesh) const;
  /// Converts a point of a face, given by coordinates with respect to its corners in Triangles, to
  /// a point of the old mesh.
  SurfacePoint ToOldMesh(
    const SurfaceMesh& oldMesh, Id face, const std::array<double, 3>& barycentric) const;
  /// Converts a point of a face of the mesh made by Build() to a point of the old mesh.
  SurfacePoint ToOldMesh(
    const SurfaceMesh& oldMesh, const SurfaceMesh& mesh, Id face, const SurfacePoint& point) const;
  /// Converts a path on the mesh made by Build() to the old mesh. Points where the path bends are
  /// kept, also inside faces of the old mesh.
  SurfacePath ToOldMesh(
    const SurfaceMesh& oldMesh, const SurfaceMesh& mesh, const SurfacePath& path) const;
};
}

#endif
