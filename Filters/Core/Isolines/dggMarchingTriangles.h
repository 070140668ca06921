// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Connects the crossings of an isoline on the boundary of a face. Internal.
#ifndef dggMarchingTriangles_h
#define dggMarchingTriangles_h

#include "dggLevelArc.h" // for LevelPoint

#include <array>   // for the sides
#include <cstddef> // for std::size_t
#include <set>     // for the searched sides
#include <utility> // for std::pair
#include <vector>  // for the nodes

namespace dgg
{
/// A crossing on the boundary of a face.
struct RimCrossing
{
  double T = 0.0; ///< along the side of the face, from 0 to 1
  Id Index = NoId;
};

/// One level on the boundary of a face.
struct LevelRim
{
  std::array<std::vector<RimCrossing>, 3> Sides; ///< crossings per side, in order around the face
  std::array<bool, 3> IsAbove{ { false, false, false } }; ///< per corner, true if above the level

  void Clear();
  std::size_t CountCrossings() const;
};

/// A coarse curve of an isoline, with the lower side on its left.
struct LevelChain
{
  Id First = NoId; ///< crossings on the boundary; NoId for a closed curve
  Id Last = NoId;
  std::vector<LevelPoint> Points; ///< points strictly between, or all points if closed
};

/// Marching triangles on a fine triangulation of one face. The triangulation has nodes between any
/// two crossings on the boundary, and at the points on sides of its triangles where wavefronts are
/// lowest or meet. The side of the level of a node is decided by the crossings if the node lies on
/// the boundary, and by the field if it lies inside. Thus every crossing belongs to exactly one
/// curve, and curves do not intersect, for any field.
class MarchingTriangles
{
public:
  /// Builds the triangulation. `cells` is the number of segments into which each side of the face
  /// is divided. `seeds` are interior points around which small closed curves may lie.
  void Build(const FaceEnvelope& envelope, const LevelArc& arc, double level, const LevelRim& rim,
    int cells, const std::vector<Point2>& seeds);

  /// Returns the curves. Curves that end on the boundary come first.
  const std::vector<LevelChain>& GetChains() const { return this->Chains; }

private:
  struct Node
  {
    LevelPoint Point;
    bool IsAbove = false;
    std::array<bool, 3> IsOnSide{ { false, false, false } }; // per side of the face
    Id LastLink = NoId; // head of the list of links whose lower node is this node
  };
  /// A side of the triangulation that the isoline crosses.
  struct Link
  {
    Id Low; // nodes
    Id High;
    Id Before = NoId;   // previous link of the same lower node
    Id Crossing = NoId; // crossing on the boundary
    Id Next = NoId;     // next link on the isoline
    bool IsReached = false;
  };
  using Triangle = std::array<Id, 3>;
  using Side = std::pair<Id, Id>; // between two nodes, the lower one first

  Id AddNode(const LevelArc& arc, double level, const Point2& place);
  void AddRim(const FaceEnvelope& envelope, const LevelArc& arc, double level, const LevelRim& rim,
    int cells);
  void AddTriangles(const FaceEnvelope& envelope, const LevelArc& arc, double level, int cells);
  void AddCell(const LevelArc& arc, double level, const Triangle& corners,
    const std::array<const std::vector<Id>*, 3>& between);
  void InsertSeed(const LevelArc& arc, double level, const Point2& seed);
  void Divide(std::size_t t, Id node);
  void CutSide(Id a, Id b, Id node);
  void AddTurns(const LevelArc& arc, double level);
  bool CutAtTurns(const LevelArc& arc, double level, Id a, Id b);
  bool IsOnRim(Id a, Id b) const;
  Id AddLink(Id low, Id high);
  Id FindLink(Id a, Id b);
  void March();
  void Follow(const LevelArc& arc);
  void FollowFrom(const LevelArc& arc, Id link);

  std::vector<Node> Nodes;
  std::vector<Link> Links;
  std::vector<Triangle> Triangles;
  std::array<std::vector<Id>, 3> RimNodes; // nodes at the division points of each side
  std::array<std::vector<std::vector<Id>>, 3>
    Between; // additional nodes between two division points
  std::vector<Id> Polygon;
  std::set<Side> Searched;
  std::vector<LevelPoint> Turns;
  std::vector<LevelChain> Chains;
};
}

#endif
