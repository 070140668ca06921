// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes made of faces of a parent mesh, or of pieces of its faces.
#ifndef dggSubMesh_h
#define dggSubMesh_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h"  // for SurfaceMesh
#include "dggSurfacePath.h"  // for SurfacePath
#include "dggSurfacePoint.h" // for SurfacePoint

#include <array>   // for barycentric coordinates
#include <cstddef> // for std::size_t
#include <vector>  // for the arrays

namespace dgg
{
/// A submesh. Each of its faces is a face of a parent mesh or a piece of one. Examples are some
/// faces of the parent, the parent with split faces, and the parent cut open. Dropped faces of the
/// parent are omitted.
struct DGG_CORE_EXPORT SubMesh
{
  /// Vertices, as points of the parent. If faces were split, vertices of the parent keep their ids,
  /// and new vertices follow.
  std::vector<SurfacePoint> Points;
  std::vector<Id> Triangles;   ///< 3 vertices per face, oriented as in the parent
  std::vector<double> Lengths; ///< per half-edge 3f+k, from corner k to corner k+1 of face f
  std::vector<Id> Twins;       ///< per half-edge, like SurfaceMesh::Twin()
  std::vector<Id> Faces;       ///< per face, the face of the parent that it lies in
  /// Per path, its vertices; consecutive vertices are neighbors. Empty after a cut.
  std::vector<std::vector<Id>> Paths;
  /// Per path, the parameters of its vertices: the index of the path segment plus the fraction
  /// within the segment. Vertex i + 1 is in the same segment as vertex i, or at the end of this
  /// segment. If both ends of short segments became one vertex, the vertex has the parameter of the
  /// first end. Empty after a cut.
  std::vector<std::vector<double>> Places;
  /// Per vertex of a surface that was cut open, the id of the original vertex; empty otherwise.
  std::vector<Id> VertexOf;

  Id GetNumberOfVertices() const { return static_cast<Id>(this->Points.size()); }
  Id GetNumberOfFaces() const { return static_cast<Id>(this->Faces.size()); }
  Id GetNumberOfHalfEdges() const { return static_cast<Id>(this->Triangles.size()); }
  Id Origin(Id h) const { return this->Triangles[h]; }
  Id Destination(Id h) const { return this->Triangles[SurfaceMesh::Next(h)]; }
  Id Twin(Id h) const { return this->Twins[h]; }

  /// Computes Twins. Half-edges belong to one edge if they have the same ends and the same entry in
  /// `places`. The entry is the id of an edge or a face of the surface before its faces were split.
  void Glue(const std::vector<Offset>& places);
  /// Builds the mesh of these faces with their lengths, so that its metric is that of the parent.
  /// Pieces of degenerate faces of the parent are degenerate as well.
  Status Build(const SurfaceMesh& parent, SurfaceMesh& mesh) const;
  /// Converts a point of a face, given by coordinates with respect to its corners in Triangles, to
  /// a point of the parent.
  SurfacePoint ToParent(
    const SurfaceMesh& parent, Id face, const std::array<double, 3>& barycentric) const;
  /// Converts a point of a face of the mesh made by Build() to a point of the parent.
  SurfacePoint ToParent(
    const SurfaceMesh& parent, const SurfaceMesh& mesh, Id face, const SurfacePoint& point) const;
  /// Converts a path on the mesh made by Build() to the parent. Points where the path bends are
  /// kept, also inside faces of the parent.
  SurfacePath ToParent(
    const SurfaceMesh& parent, const SurfaceMesh& mesh, const SurfacePath& path) const;
};

/// Selects faces of a mesh as submeshes. Buffers have the size of the mesh and are reused, so that
/// the cost of a submesh depends only on its faces.
class DGG_CORE_EXPORT FaceSelector
{
public:
  explicit FaceSelector(const SurfaceMesh& parent);

  /// Adds a face, which must not be dropped. Returns false if the face was selected before.
  bool AddFace(Id face);
  /// Adds a vertex of a selected face and returns its id in the submesh. Take() adds the other
  /// vertices, in the order in which the faces contain them.
  Id AddVertex(Id vertex);
  /// Returns the id of a vertex in the submesh; NoId if the vertex was not added.
  Id GetVertexId(Id vertex) const { return this->VertexIds[vertex]; }
  /// Returns the selected faces in the order in which they were added.
  const std::vector<Id>& GetFaces() const { return this->Selected.Faces; }
  /// Returns the submesh of the selected faces and clears the selection. At an edge some of whose
  /// faces are not selected, the selected faces are glued to each other.
  SubMesh Take();
  void Clear();
  /// Returns the submesh of the given faces, in their order.
  SubMesh Select(const std::vector<Id>& faces);

  /// Returns the size of the reused buffers in bytes, excluding submeshes.
  std::size_t GetMemorySize() const
  {
    return (this->VertexIds.size() + this->FaceIds.size()) * sizeof(Id);
  }

private:
  Id FindTwin(Id h) const;

  const SurfaceMesh& Parent;
  SubMesh Selected;          // points and faces only
  std::vector<Id> VertexIds; // per vertex, its id in the submesh or NoId
  std::vector<Id> FaceIds;   // per face, its id in the submesh or NoId
};

/// Returns the faces of each component of a mesh that has faces, without dropped faces.
std::vector<std::vector<Id>> FindComponentFaces(const SurfaceMesh& mesh);
}

#endif
