// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Some faces of a mesh as a mesh of their own. Internal.
#ifndef dggMeshPart_h
#define dggMeshPart_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for vertices and faces

namespace dgg
{
struct MeshPart
{
  std::vector<Id> Faces;    ///< of the whole, increasing; none of them dropped
  std::vector<Id> Vertices; ///< of the whole, in the order in which the faces have them
  SurfaceMesh Mesh;

  /// Make the rest from the faces. Where an edge has faces that are not among them, those that are
  /// meet each other.
  Status Build(const SurfaceMesh& whole);
};

/// The components that have faces.
std::vector<MeshPart> FindComponentParts(const SurfaceMesh& mesh);
}

#endif
