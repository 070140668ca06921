// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The half-edges of paths on a submesh. Internal.
#ifndef dggPathEdges_h
#define dggPathEdges_h

#include "dggSubMesh.h" // for SubMesh

#include <utility> // for edges
#include <vector>  // for half-edges

namespace dgg
{
/// The edges of paths, which are chains of neighboring vertices such as SubMesh::Paths. The surface
/// must outlive this object.
class PathEdges
{
public:
  PathEdges(const SubMesh& surface, const std::vector<std::vector<Id>>& paths);

  const SubMesh& GetSurface() const { return this->Surface; }
  /// Returns true if an edge of a path ends at the vertex.
  bool IsVertexOnPath(Id v) const { return this->IsPassed[v] != 0; }
  /// Returns true if the edge of the half-edge is an edge of a path.
  bool IsOnPath(Id h) const;
  /// Returns all half-edges of an edge of a path, in either direction and in increasing order.
  std::vector<Id> Find(Id a, Id b) const;

private:
  using Edge = std::pair<Id, Id>; // smaller vertex first

  const SubMesh& Surface;
  std::vector<char> IsPassed;                 // per vertex
  std::vector<std::pair<Edge, Id>> HalfEdges; // sorted
};
}

#endif
