// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points through which paths on a mesh run. Internal.
#ifndef dggPathNodes_h
#define dggPathNodes_h

#include "dggFaceTriangulation.h" // for GridPoint
#include "dggSurfacePath.h"       // for SurfacePath

#include <array>   // for corners
#include <cstdint> // for places on edges
#include <map>     // for nodes by edge and face
#include <set>     // for nodes by place
#include <tuple>   // for the same
#include <utility> // for marks
#include <vector>  // for nodes

namespace dgg
{
/// Nodes: the vertices of a mesh and the points on paths, numbered consecutively. Vertices keep
/// their ids, followed by points on edges, then points inside faces. Points close together are
/// merged into one node; points close to a vertex are merged with the vertex.
class PathNodes
{
public:
  /// Merge distance on the grid (1e-9, the snapping distance of SurfacePoint).
  static constexpr std::int64_t MergeDistance = GridPoint::One / 1000000000;

  explicit PathNodes(const SurfaceMesh& mesh);

  /// Adds the points of all paths on edges. Must be called once, before any other function.
  void AddPointsOnEdges(const std::vector<SurfacePath>& paths);
  /// Returns the node of a path point; a new point inside a face is added.
  Id NodeOf(const SurfacePoint& point);
  /// Returns a node for a crossing of paths inside a face: an existing node within the merge
  /// distance, otherwise a new one.
  Id AddCrossing(const GridPoint& place, Id face);

  bool IsInside(Id node) const
  {
    return node >= this->NumberOfVertices &&
      this->Nodes[node - this->NumberOfVertices].Face != NoId;
  }
  /// Returns the nodes on the edge of a half-edge, sorted from the origin of its FindEdge(). Null
  /// if there are none.
  const std::vector<Id>* FindOnEdge(Id h) const;
  /// Returns the nodes inside a face, in order of insertion. Null if there are none.
  const std::vector<Id>* FindInFace(Id face) const;
  /// Returns all nodes of a face: corners, nodes on its sides, nodes inside.
  std::vector<Id> CollectNodes(Id face) const;

  /// Returns the position of a node in one of its faces.
  GridPoint PlaceOf(Id node, Id face) const;
  /// Returns true if two nodes lie on the same side of a face. `side` receives the index of this
  /// side, which runs from corner `side` to the next corner.
  bool AreOnOneSide(Id a, Id b, Id face, int& side) const;
  /// Returns the node after a towards b along a side of a face.
  Id FindNextOnSide(Id a, Id b, Id face, int side) const;
  /// Returns the distance of two nodes of a face. Along a mesh edge it is bitwise identical in all
  /// faces of the edge.
  double Measure(Id a, Id b, Id face) const;

  /// Returns all nodes as surface points.
  std::vector<SurfacePoint> MakePoints() const;

private:
  /// A node that is not a vertex.
  struct Node
  {
    Id Edge = NoId;     // on an edge: its smallest half-edge; otherwise NoId
    Id Face = NoId;     // inside a face: the face; otherwise NoId
    std::int64_t T = 0; // on an edge: from the origin, in units of 1 / One
    GridPoint Place;    // inside a face
  };
  using EdgeMark = std::pair<Id, std::int64_t>;

  EdgeMark MarkOf(const SurfacePoint& point) const;
  Id Append(const Node& node);
  int PositionOnSide(Id node, Id face, int side) const;

  const SurfaceMesh& Mesh;
  Id NumberOfVertices;
  std::vector<Node> Nodes;              // after the vertices
  std::vector<EdgeMark> Marks;          // crossings of edges, sorted
  std::vector<Id> MarkNodes;            // the nodes of the marks
  std::map<Id, std::vector<Id>> OnEdge; // per crossed edge, sorted along the edge
  std::map<Id, std::vector<Id>> InFace; // per face, nodes inside
  std::set<std::tuple<Id, std::int64_t, std::int64_t, Id>>
    ByPlace; // nodes inside faces: face, X, Y, node
};
}

#endif
