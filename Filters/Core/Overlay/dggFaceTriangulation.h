// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangulates one triangle with points and segments in it. Internal.
#ifndef dggFaceTriangulation_h
#define dggFaceTriangulation_h

#include "dggUnfolding.h" // for Point2

#include <array>   // for triangles and barycentric coordinates
#include <cstddef> // for orders
#include <cstdint> // for grid coordinates
#include <deque>   // for edges that are crossed
#include <utility> // for edges
#include <vector>  // for points and triangles

namespace dgg
{
/// A point of a triangle on a fine grid: the barycentric coordinates of corners 1 and 2 in units of
/// 1 / One. On the grid every orientation test is exact, points of a side are in line, and the
/// shape of the triangle does not matter; coordinates are doubles without rounding.
struct GridPoint
{
  static constexpr std::int64_t One = std::int64_t(1) << 50;

  std::int64_t X = 0;
  std::int64_t Y = 0;

  static GridPoint FromBarycentric(const std::array<double, 3>& b);
  std::array<double, 3> GetBarycentric() const;
  bool operator==(const GridPoint& other) const { return this->X == other.X && this->Y == other.Y; }
};

/// 1 when a, b, c turn left, -1 when they turn right, 0 when they are in line. Exact.
int Orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c);

/// Whether the segments ab and cd cross at a point inside both.
bool CrossProperly(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d);

/// A constrained triangulation, Delaunay in the plane of the face where the segments allow it, up
/// to rounding. Points are found by walking from the last one.
class FaceTriangulation
{
public:
  /// Starts with the triangle of the three corners, points 0, 1 and 2, given their places in the
  /// plane, counter-clockwise.
  explicit FaceTriangulation(const std::array<Point2, 3>& corners);

  /// Add a point that differs from the others; returns its index.
  int AddPoint(const GridPoint& point);
  /// Make two points neighbours. No other point may lie between them, and no segment cross. False
  /// when that is not so.
  bool AddSegment(int a, int b);
  /// Improve the triangles once more without touching segments.
  void MakeDelaunay();

  /// Counter-clockwise.
  const std::vector<std::array<int, 3>>& GetTriangles() const { return this->Triangles; }

private:
  /// What lies beyond a side of a triangle.
  struct Side
  {
    int Twin = -1; // the half-edge of the neighbour
    char IsSegment = 0;
  };
  using Sides = std::array<Side, 3>;

  // Half-edge 3 t + k goes from corner k of triangle t to the next one.
  int Origin(int h) const { return this->Triangles[h / 3][h % 3]; }
  int Destination(int h) const { return this->Triangles[h / 3][(h + 1) % 3]; }
  void Set(int triangle, const std::array<int, 3>& corners, const Sides& sides);
  int NewTriangle();
  void Glue(int h, int twin);
  Sides SidesOf(int triangle) const;

  int Locate(const GridPoint& point);
  bool IsIn(int triangle, const GridPoint& point) const;
  void SplitTriangle(int t, int p);
  void SplitEdge(int h, int p);
  int FindEdge(int a, int b) const;
  bool FindCrossed(int a, int b, std::deque<std::pair<int, int>>& crossed) const;
  void Fix(int h);
  bool CanFlip(int h) const;
  void Flip(int h);
  Point2 Way(int from, int to) const;
  bool IsBad(int h) const;
  void Improve(std::vector<int>& edges);

  Point2 First;  // from corner 0 of the face to corner 1, scaled
  Point2 Second; // and to corner 2
  std::vector<GridPoint> Points;
  std::vector<std::array<int, 3>> Triangles;
  std::vector<int> Twins;      // per half-edge; -1 on the rim
  std::vector<char> IsSegment; // per half-edge
  std::vector<int> Starts;     // per point, a half-edge that starts there
  int LastTriangle = 0;        // where the last point came in
};

/// An order of points in which FaceTriangulation::AddPoint() takes the same time for each, however
/// many there are: rounds of points picked at random, each one twice as large as the one before and
/// in the order of a curve that fills the triangle (Amenta, Choi and Rote, "Incremental
/// constructions con BRIO", 2003). Depends on the points only. Segments are added fast in the order
/// of points on them.
std::vector<std::size_t> MakeInsertionOrder(const std::vector<GridPoint>& points);
}

#endif
