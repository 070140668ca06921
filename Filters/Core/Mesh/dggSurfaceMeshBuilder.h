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
  /// Link the half-edges on equal vertex pairs. Faces that name a vertex twice take no part, nor do
  /// those with the three vertices of an earlier one.
  void GlueByVertices();
  Status GlueByTwins(const Id* twins);
  Status MeasureLengths(const double* points);
  Status TakeLengths(const double* lengths);
  /// Refuse lengths that no triangle can have, rather than mollify them.
  Status CheckTriangleInequalities() const;
  /// Whatever is known of the faces already.
  void TakeOrigin(const PartOfMesh& origin);
  /// Turn faces over, component by component, where that makes the orientation consistent.
  void Orient();
  /// Lengthen the edges of degenerate faces.
  void Mollify();
  /// Everything that follows from connectivity and lengths, but angles.
  void Finish();

private:
  void DropRepeatedVertexFaces();
  void GlueEdge(std::vector<Id>::iterator begin, std::vector<Id>::iterator end);
  void DropDuplicates(std::vector<Id>::iterator begin, std::vector<Id>::iterator end);
  double MeasureLack(Id f) const;
  void MeasureEdges();
  void LayOutFaces();
  bool FindLinks();
  void OrderFans();
  bool IsRegular(Id v) const;
  Status CheckExtent(double extent, const char* what) const;

  SurfaceMesh& Mesh;
  const SurfaceMesh* Whole = nullptr; // what the mesh is a part of
  /// Per half-edge, whether its edge has two half-edges that run in opposite directions.
  std::vector<std::uint8_t> IsLinked;
  std::vector<std::pair<Id, Id>> Apexes; // of the faces on an edge, with their half-edges
};
}

#endif
