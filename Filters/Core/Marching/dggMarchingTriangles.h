// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangles that stand in for the obtuse ones of a mesh. Internal.
#ifndef dggMarchingTriangles_h
#define dggMarchingTriangles_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <cstddef> // for std::size_t
#include <vector>  // for triangles

namespace dgg
{
/// A triangle through which a front may reach its apex: a face, or one that was unfolded over
/// several faces. Seen from the apex, `Left` follows on `Right` counter-clockwise.
struct MarchingTriangle
{
  Id Apex;
  Id Right;
  Id Left;
  double Base;      ///< from Right to Left
  double ToRight;   ///< from the apex
  double ToLeft;    ///< from the apex
  double Direction; ///< polar angle at the apex towards Right
};

/// For every obtuse corner of a mesh the triangles between it and a vertex beyond the opposite
/// edge, in the plane of the face, so that they are not obtuse at the corner (Kimmel and Sethian
/// 1998, section 4). A strip of faces is unfolded for that; it ends without result at the boundary
/// and where no vertex comes into sight. Across a non-manifold edge there is a strip for each face.
class MarchingTriangles
{
public:
  explicit MarchingTriangles(const SurfaceMesh& mesh);

  /// The triangle of the corner at the origin of a half-edge.
  static MarchingTriangle FromFace(const SurfaceMesh& mesh, Id h);

  /// Triangles whose base has the vertex at one end.
  const Id* Begin(Id vertex) const { return this->ByVertex.data() + this->Offsets[vertex]; }
  const Id* End(Id vertex) const { return this->ByVertex.data() + this->Offsets[vertex + 1]; }
  const MarchingTriangle& Get(Id i) const { return this->Triangles[i]; }

  std::size_t GetMemorySize() const;

private:
  void Split(const SurfaceMesh& mesh, Id h);

  std::vector<MarchingTriangle> Triangles;
  std::vector<Offset> Offsets;
  std::vector<Id> ByVertex;
};
}

#endif
