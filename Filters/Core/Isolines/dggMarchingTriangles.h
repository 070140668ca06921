// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which crossings on the rim of a face an isoline connects. Internal.
#ifndef dggMarchingTriangles_h
#define dggMarchingTriangles_h

#include "dggLevelArc.h" // for LevelPoint

#include <array>   // for the sides
#include <cstddef> // for std::size_t
#include <set>     // for the sides that have been looked at
#include <utility> // for std::pair
#include <vector>  // for the nodes

namespace dgg
{
/// A crossing on the rim of a face.
struct RimCrossing
{
  double T = 0.0; ///< along the side of the face, from 0 to 1
  Id Index = NoId;
};

/// What is known of one level on the rim of a face.
struct LevelRim
{
  std::array<std::vector<RimCrossing>, 3> Sides;          ///< in order around the face
  std::array<bool, 3> IsAbove{ { false, false, false } }; ///< the corners

  void Clear();
  std::size_t CountCrossings() const;
};

/// A curve of an isoline, roughly: its lower side is on its left.
struct LevelChain
{
  Id First = NoId; ///< crossings on the rim; NoId for a closed curve
  Id Last = NoId;
  std::vector<LevelPoint> Points; ///< strictly between, or all of a closed one
};

/// Marching triangles on a fine triangulation of one face, which has nodes between any two
/// crossings on the rim, and on ridges that lie above the level, and, where there are several
/// sources in the face, wherever their waves are lowest or meet on sides of its triangles. On the
/// rim the crossings decide which side of the level nodes are on, and inside the field does, so
/// that every crossing belongs to exactly one curve, and curves do not cross, whatever the field is
/// like.
class MarchingTriangles
{
public:
  /// `cells` is the number of parts that the sides of the face are cut into. `seeds` are points
  /// inside of which small closed curves may be.
  void Build(const FaceProfile& profile, const LevelArc& arc, double level, const LevelRim& rim,
    int cells, const std::vector<Point2>& seeds);

  /// The curves, those that end on the rim first.
  const std::vector<LevelChain>& GetChains() const { return this->Chains; }

private:
  struct Node
  {
    LevelPoint Point;
    bool IsAbove = false;
    std::array<bool, 3> IsOnSide{ { false, false, false } }; // of the face
    // The last link and crest whose lower node this is; those before are behind them.
    Id LastLink = NoId;
    Id LastCrest = NoId;
  };
  /// A side of small triangles that the isoline crosses.
  struct Link
  {
    Id Low; // nodes
    Id High;
    Id Before = NoId;   // link of the same lower node
    Id Crossing = NoId; // on the rim
    Id Next = NoId;     // that the isoline goes to
    bool IsReached = false;
  };
  using Triangle = std::array<Id, 3>;
  using Side = std::pair<Id, Id>; // between two nodes, the lower one first

  Id AddNode(const LevelArc& arc, double level, const Point2& place);
  void AddRim(const FaceProfile& profile, const LevelArc& arc, const LevelRim& rim, int cells);
  void AddTriangles(const FaceProfile& profile, const LevelArc& arc, double level, int cells);
  void AddCell(const LevelArc& arc, double level, const Triangle& corners,
    const std::array<const std::vector<Id>*, 3>& between);
  void InsertSeed(const LevelArc& arc, double level, const Point2& seed);
  void CutSide(Id a, Id b, Id node);
  void AddTurns(const LevelArc& arc, double level);
  bool CutAtTurns(const LevelArc& arc, double level, Id a, Id b);
  bool CutAtMeeting(const LevelArc& arc, double level, std::size_t t);
  void AddCrests(const LevelArc& arc, double level);
  Id FindCrest(const LevelArc& arc, double level, Id a, Id b);
  Id FindDip(const LevelArc& arc, double level, Id a, Id b);
  bool IsOnRim(Id a, Id b) const;
  Id AddLink(Id low, Id high);
  Id FindLink(Id a, Id b);
  void March();
  void Follow(const LevelArc& arc);
  void FollowFrom(const LevelArc& arc, Id link);

  /// A side of small triangles that a ridge crosses above the level, though both ends are below it.
  struct Crest
  {
    Id High;   // node; the lower one knows its crests
    Id Before; // crest of the same lower node
    Id Node;   // on the ridge; NoId when there is none
  };

  std::vector<Node> Nodes;
  std::vector<Crest> Crests;
  std::vector<Link> Links;
  std::vector<Triangle> Triangles;
  std::array<std::vector<Id>, 3> RimNodes;             // at the cuts of each side
  std::array<std::vector<std::vector<Id>>, 3> Between; // further nodes between two of them
  std::vector<Id> Polygon;
  std::set<Side> Looked;
  std::vector<LevelPoint> Turns;
  std::vector<LevelChain> Chains;
};
}

#endif
