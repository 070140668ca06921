// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A submesh: some faces of a mesh as a separate mesh. Internal.
#ifndef dggMeshPart_h
#define dggMeshPart_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for vertices and faces

namespace dgg
{
struct MeshPart
{
  std::vector<Id> Faces;    ///< faces of the parent mesh, ascending; none of them dropped
  std::vector<Id> Vertices; ///< vertices of the parent mesh, in order of first use by the faces
  SurfaceMesh Mesh;

  /// Builds vertices and mesh from the faces. At an edge with faces outside the submesh, the
  /// remaining faces are glued to each other.
  Status Build(const SurfaceMesh& whole);
};

/// Returns the components that have faces as submeshes.
std::vector<MeshPart> FindComponentParts(const SurfaceMesh& mesh);
}

#endif
