// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parts of a mesh that are not connected, each with numbers of its own. Internal.
#ifndef dggSurfaceComponents_h
#define dggSurfaceComponents_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for the numbers

namespace dgg
{
/// The components of a mesh, as SurfaceMesh::ComputeComponents() counts them. In each of them
/// vertices and faces are numbered from 0, in the order of their ids, so that arrays for one
/// component take no more memory than it needs. Dropped faces are in none.
class SurfaceComponents
{
public:
  explicit SurfaceComponents(const SurfaceMesh& mesh);

  const SurfaceMesh& GetMesh() const { return this->Mesh; }
  Id GetCount() const { return static_cast<Id>(this->FirstVertices.size()) - 1; }
  Id GetComponent(Id v) const { return this->Components[v]; }

  Id GetNumberOfVertices(Id c) const { return this->FirstVertices[c + 1] - this->FirstVertices[c]; }
  Id GetNumberOfFaces(Id c) const { return this->FirstFaces[c + 1] - this->FirstFaces[c]; }
  /// Face number `local` of a component.
  Id GetFace(Id c, Id local) const { return this->Faces[this->FirstFaces[c] + local]; }

  /// Numbers within the component.
  Id NumberOfVertex(Id v) const { return this->VertexNumbers[v]; }
  Id NumberOfFace(Id f) const { return this->FaceNumbers[f]; }
  Id NumberOfHalfEdge(Id h) const { return 3 * this->FaceNumbers[SurfaceMesh::Face(h)] + h % 3; }

private:
  const SurfaceMesh& Mesh;
  std::vector<Id> Components;    // per vertex
  std::vector<Id> VertexNumbers; // per vertex
  std::vector<Id> FaceNumbers;   // per face
  std::vector<Id> FirstVertices; // per component, how many vertices are in those before
  std::vector<Id> FirstFaces;    // per component, where its faces start
  std::vector<Id> Faces;         // component by component
};
}

#endif
