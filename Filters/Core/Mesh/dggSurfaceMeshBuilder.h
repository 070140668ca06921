// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The steps that turn triangles and lengths into a SurfaceMesh. Internal to the kernel.
#ifndef dggSurfaceMeshBuilder_h
#define dggSurfaceMeshBuilder_h

#include "dggGroups.h"      // for Groups
#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for std::vector

namespace dgg
{
class SurfaceMeshBuilder
{
public:
  explicit SurfaceMeshBuilder(SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  Status TakeTriangles(Offset numberOfVertices, const Id* triangles, Offset numberOfTriangles);
  /// Links half-edges with equal vertex pairs. Faces that contain a vertex twice and faces with the
  /// three vertices of an earlier one are ignored. `isRim` is documented in SurfaceMesh.
  void GlueByVertices(const std::uint8_t* isRim = nullptr);
  Status GlueByTwins(const Id* twins);
  Status MeasureLengths(const double* points);
  Status TakeLengths(const double* lengths);
  /// Fails if lengths violate the triangle inequality, rather than mollifying the faces.
  Status CheckTriangleInequalities() const;
  /// Copies the properties of faces that are inherited from a parent mesh.
  void TakeOrigin(const PartOfMesh& origin);
  /// Flips faces, component by component, if flips make the orientation consistent.
  void Orient();
  /// Lengthens the edges of degenerate faces.
  void Mollify();
  /// Computes all properties that follow from connectivity and lengths, except angles.
  void Finish();

private:
  /// The last half-edge found between a vertex and a smaller neighbor.
  struct LastHalfEdge
  {
    Id Smaller = NoId;
    Id HalfEdge = NoId;
    Id Apex = NoId;
  };

  bool IsLinked(Id h) const;
  void DropRepeatedVertexFaces();
  void GroupByOrigin();
  void Glue(Id v, Id neighbor, Id h, Id apex);
  void RelinkWithoutDuplicates(Id edge);
  double TriangleInequalityViolation(Id f) const;
  void MeasureMeanEdge();
  void LayOutFaces();
  bool FindLinks();
  void OrderFans();
  bool IsRegular(Id v) const;
  Status DescribeNotFinite(const double* points) const;
  Status CheckExtent(double extent, const char* what) const;

  SurfaceMesh& Mesh;
  const SurfaceMesh* Parent = nullptr; // parent mesh, or null
  Groups Outgoing;                     // half-edges by origin, without dropped faces
  bool AreAllLinked = false;           // true if all edges off the boundary are known to be linked
  std::vector<LastHalfEdge> LastHalfEdges; // per vertex, with the last of its smaller neighbors
  std::vector<Id> CrowdedEdges; // half-edges whose edges have more than two faces, or duplicates
};
}

#endif
