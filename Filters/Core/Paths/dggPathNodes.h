// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points that paths on a mesh run through. Internal.
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
/// The vertices of a mesh and the points that paths pass, numbered: vertices with their ids, then
/// points on edges, then points in faces. Points close together are one node; those close to a
/// vertex are the vertex.
class PathNodes
{
public:
  /// Points this close together on the grid are one (1e-9, as SurfacePoint snaps).
  static constexpr std::int64_t MergeDistance = GridPoint::One / 1000000000;

  explicit PathNodes(const SurfaceMesh& mesh);

  /// Add the points of all paths on edges. To be called once, before anything else.
  void AddPointsOnEdges(const std::vector<SurfacePath>& paths);
  /// The node of a point of a path; a point in a face is added when it is new.
  Id NodeOf(const SurfacePoint& point);
  /// The node in a face where paths cross: a new one, unless there is one so close that it would be
  /// the same.
  Id AddCrossing(const GridPoint& place, Id face);

  bool IsInside(Id node) const
  {
    return node >= this->NumberOfVertices &&
      this->Nodes[node - this->NumberOfVertices].Face != NoId;
  }
  /// Nodes on the edge of a half-edge, from the origin of its FindEdge() on. Null when there are
  /// none.
  const std::vector<Id>* FindOnEdge(Id h) const;
  /// Nodes inside a face, in the order in which they came. Null when there are none.
  const std::vector<Id>* FindInFace(Id face) const;
  /// All nodes of a face: its corners, those on its sides, those inside.
  std::vector<Id> CollectNodes(Id face) const;

  /// Where a node lies in one of its faces.
  GridPoint PlaceOf(Id node, Id face) const;
  /// Whether two nodes lie on one side of a face, and on which: that from corner `side` to the
  /// next.
  bool AreOnOneSide(Id a, Id b, Id face, int& side) const;
  /// The node that follows a on the way to b along a side of a face.
  Id FindNextOnSide(Id a, Id b, Id face, int side) const;
  /// Distance of two nodes of a face. Along an edge of the mesh it has the same bits in all faces
  /// of the edge.
  double Measure(Id a, Id b, Id face) const;

  /// All nodes as points of the mesh.
  std::vector<SurfacePoint> MakePoints() const;

private:
  /// Where a path passes.
  struct Node
  {
    Id Edge = NoId;     // the smallest half-edge of the edge that it is on, or
    Id Face = NoId;     // the face that it is in
    std::int64_t T = 0; // on an edge: from the origin, in units of 1 / One
    GridPoint Place;    // in a face
  };
  using EdgeMark = std::pair<Id, std::int64_t>;

  EdgeMark MarkOf(const SurfacePoint& point) const;
  Id Append(const Node& node);
  int PositionOnSide(Id node, Id face, int side) const;

  const SurfaceMesh& Mesh;
  Id NumberOfVertices;
  std::vector<Node> Nodes;              // after the vertices
  std::vector<EdgeMark> Marks;          // where edges are crossed, sorted
  std::vector<Id> MarkNodes;            // the nodes of the marks
  std::map<Id, std::vector<Id>> OnEdge; // per edge crossed, in order
  std::map<Id, std::vector<Id>> InFace; // nodes inside a face
  std::set<std::tuple<Id, std::int64_t, std::int64_t, Id>> ByPlace; // the same: face, X, Y, node
};
}

#endif
