// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The steps that turn triangles and lengths into a SurfaceMesh. Internal to the kernel.
#ifndef dggSurfaceMeshBuilder_h
#define dggSurfaceMeshBuilder_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <cstdint> // for the marks
#include <utility> // for std::pair
#include <vector>  // for std::vector

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
  /// three vertices of an earlier one are ignored.
  void GlueByVertices();
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
  void DropRepeatedVertexFaces();
  void GlueEdge(std::vector<Id>::iterator begin, std::vector<Id>::iterator end);
  void DropDuplicates(std::vector<Id>::iterator begin, std::vector<Id>::iterator end);
  double TriangleInequalityViolation(Id f) const;
  void MeasureEdges();
  void LayOutFaces();
  bool FindLinks();
  void OrderFans();
  bool IsRegular(Id v) const;
  Status CheckExtent(double extent, const char* what) const;

  SurfaceMesh& Mesh;
  const SurfaceMesh* Whole = nullptr; // parent mesh, or null
  /// Per half-edge, true if its edge has two half-edges that run in opposite directions.
  std::vector<std::uint8_t> IsLinked;
  std::vector<std::pair<Id, Id>> Apexes; // apexes of the faces on an edge, with their half-edges
};
}

#endif
