// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A mesh with split faces, and the way back to the old one.
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
/// old mesh are left out.
struct DGG_CORE_EXPORT RefinedSurface
{
  /// The vertices, as points of the old mesh: its own, with their ids, then new ones.
  std::vector<SurfacePoint> Points;
  std::vector<Id> Triangles;   ///< 3 vertices per face, oriented as in the old mesh
  std::vector<double> Lengths; ///< per half-edge 3f+k, from corner k to corner k+1 of face f
  std::vector<Id> Twins;       ///< per half-edge, as SurfaceMesh::Twin()
  std::vector<Id> Faces;       ///< per face, the old face that it is part of
  /// Per path, the vertices that it runs through; each is a neighbour of the next.
  std::vector<std::vector<Id>> Paths;
  /// Per path, where its vertices are along it: the number of the piece of the path, plus the part
  /// of the piece that lies behind. Vertex i + 1 is in the same piece as vertex i, or at its end.
  /// Where pieces are so short that both ends became one vertex, it has the place of the first.
  std::vector<std::vector<double>> Places;

  Id GetNumberOfVertices() const { return static_cast<Id>(this->Points.size()); }
  Id GetNumberOfFaces() const { return static_cast<Id>(this->Faces.size()); }
  Id GetNumberOfHalfEdges() const { return static_cast<Id>(this->Triangles.size()); }
  Id Origin(Id h) const { return this->Triangles[h]; }
  Id Destination(Id h) const { return this->Triangles[SurfaceMesh::Next(h)]; }
  Id Twin(Id h) const { return this->Twins[h]; }

  /// Make Twins: half-edges are of one edge when they have the same ends and lie in the same place,
  /// which is any number that identifies an edge or a face of the surface before.
  void Glue(const std::vector<Offset>& places);
  /// The mesh with these faces and their lengths, so that its metric is the old one. Parts of faces
  /// of the old mesh that are degenerate are so as well.
  Status Build(const SurfaceMesh& oldMesh, SurfaceMesh& mesh) const;
  /// A point of a face, given by coordinates with respect to its corners in Triangles, as a point
  /// of the old mesh.
  SurfacePoint ToOldMesh(
    const SurfaceMesh& oldMesh, Id face, const std::array<double, 3>& barycentric) const;
  /// A point of a face of the mesh that Build() made, as a point of the old mesh.
  SurfacePoint ToOldMesh(
    const SurfaceMesh& oldMesh, const SurfaceMesh& mesh, Id face, const SurfacePoint& point) const;
  /// A path on the mesh that Build() made, on the old mesh. Where it bends it keeps its points,
  /// also inside faces of the old mesh.
  SurfacePath ToOldMesh(
    const SurfaceMesh& oldMesh, const SurfaceMesh& mesh, const SurfacePath& path) const;
};
}

#endif
