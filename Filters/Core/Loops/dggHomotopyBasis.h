// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Non-contractible loops of mesh edges, by component. Internal.
#ifndef dggHomotopyBasis_h
#define dggHomotopyBasis_h

#include "dggGroups.h"      // for Groups
#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <cstdint> // for signatures
#include <vector>  // for the loops

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
  Id GetCount() const { return static_cast<Id>(this->Faces.Begins.size()) - 1; }
  Id GetComponent(Id v) const { return this->Components[v]; }

  Id GetNumberOfVertices(Id c) const { return SizeOf(this->Vertices, c); }
  Id GetNumberOfFaces(Id c) const { return SizeOf(this->Faces, c); }
  /// Returns the face with local index `local` in a component.
  Id GetFace(Id c, Id local) const { return this->Faces.Members[this->Faces.Begins[c] + local]; }

  /// Returns the local index of a vertex or a face within its component.
  Id NumberOfVertex(Id v) const { return this->VertexNumbers[v]; }
  Id NumberOfFace(Id f) const { return this->FaceNumbers[f]; }
  Id NumberOfHalfEdge(Id h) const { return 3 * this->FaceNumbers[SurfaceMesh::Face(h)] + h % 3; }

private:
  static Id SizeOf(const Groups& groups, Id c)
  {
    return static_cast<Id>(groups.Begins[c + 1] - groups.Begins[c]);
  }

  const SurfaceMesh& Mesh;
  std::vector<Id> Components; // per vertex
  Groups Vertices;            // sorted by component
  Groups Faces;
  std::vector<Id> VertexNumbers; // per vertex
  std::vector<Id> FaceNumbers;   // per face
};

/// A closed chain of mesh edges: half-edge i leads from vertex i to vertex i + 1, forwards or
/// backwards, and the last one back to vertex 0.
struct EdgeLoop
{
  std::vector<Id> Vertices;
  std::vector<Id> HalfEdges;
  double Length = 0.0;
};

/// Homology signatures modulo 2, which determine whether loops of a component are independent.
class HomologySignatures
{
public:
  /// Computes the dual cycles of the component that contains the vertex `base`. If Check() fails,
  /// no other function may be called.
  HomologySignatures(const SurfaceComponents& components, Id base);
  const Status& Check() const { return this->TheStatus; }
  /// Returns the dimension: two for each handle, one for each boundary loop but the last, one for
  /// each cross-cap.
  std::size_t GetDimension() const { return this->Dimension; }
  /// Returns the signature of a loop. Bit i is bit i % 64 of word i / 64.
  std::vector<std::uint64_t> GetSignature(const EdgeLoop& loop) const;

private:
  const SurfaceComponents& Components;
  Status TheStatus;
  std::size_t Dimension = 0;
  /// Per half-edge that represents an edge of the component, the dual cycles that contain the edge.
  std::vector<std::vector<Id>> Cycles;
};

/// Finds the vertex of smallest id of each component with non-contractible loops. Fails on
/// non-manifold edges.
Status FindBasesOfLoops(const SurfaceComponents& components, std::vector<Id>& bases);

/// Finds the shortest loops of edges through the vertex `base` that generate all other loops on its
/// component, shortest first: two for each handle, one for each boundary loop but the last, one for
/// each cross-cap (greedy homotopy basis: Erickson and Whittlesey, "Greedy optimal homotopy and
/// homology generators", 2005, sec. 3). Fails on a component with non-manifold edges.
Status FindHomotopyBasis(
  const SurfaceComponents& components, Id base, std::vector<EdgeLoop>& loops);
}

#endif
