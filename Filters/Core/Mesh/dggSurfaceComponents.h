// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Connected components of a mesh with local indices. Internal.
#ifndef dggSurfaceComponents_h
#define dggSurfaceComponents_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for the numbers

namespace dgg
{
/// The components of a mesh, as numbered by SurfaceMesh::ComputeComponents(). Vertices and faces of
/// each component have local indices from 0 on, in the order of their ids, so that arrays for one
/// component only need memory for that component. Dropped faces belong to no component.
class SurfaceComponents
{
public:
  explicit SurfaceComponents(const SurfaceMesh& mesh);

  const SurfaceMesh& GetMesh() const { return this->Mesh; }
  Id GetCount() const { return static_cast<Id>(this->FirstVertices.size()) - 1; }
  Id GetComponent(Id v) const { return this->Components[v]; }

  Id GetNumberOfVertices(Id c) const { return this->FirstVertices[c + 1] - this->FirstVertices[c]; }
  Id GetNumberOfFaces(Id c) const { return this->FirstFaces[c + 1] - this->FirstFaces[c]; }
  /// Returns the face with local index `local` in a component.
  Id GetFace(Id c, Id local) const { return this->Faces[this->FirstFaces[c] + local]; }

  /// Local indices within the component.
  Id NumberOfVertex(Id v) const { return this->VertexNumbers[v]; }
  Id NumberOfFace(Id f) const { return this->FaceNumbers[f]; }
  Id NumberOfHalfEdge(Id h) const { return 3 * this->FaceNumbers[SurfaceMesh::Face(h)] + h % 3; }

private:
  const SurfaceMesh& Mesh;
  std::vector<Id> Components;    // per vertex
  std::vector<Id> VertexNumbers; // per vertex
  std::vector<Id> FaceNumbers;   // per face
  std::vector<Id> FirstVertices; // per component, number of vertices in earlier components
  std::vector<Id> FirstFaces;    // per component, offset of its first face in Faces
  std::vector<Id> Faces;         // sorted by component
};
}

#endif
