// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Constrained triangulation of one face with points and segments. Internal.
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
/// 1 / One. On the grid every orientation test is exact, points on a side are exactly collinear,
/// and the shape of the triangle is irrelevant; the conversion to double is exact.
struct GridPoint
{
  static constexpr std::int64_t One = std::int64_t(1) << 50;

  std::int64_t X = 0;
  std::int64_t Y = 0;

  static GridPoint FromBarycentric(const std::array<double, 3>& b);
  std::array<double, 3> GetBarycentric() const;
  bool operator==(const GridPoint& other) const { return this->X == other.X && this->Y == other.Y; }
};

/// Returns 1 if a, b, c turn left, -1 if they turn right, 0 if they are collinear. Exact.
int Orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c);

/// Returns true if the segments ab and cd cross at a point interior to both.
bool CrossProperly(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d);

/// A constrained Delaunay triangulation in the plane of the face, up to rounding. Points are
/// located by walking from the previous one.
class FaceTriangulation
{
public:
  /// Starts with the triangle of the three corners, points 0, 1 and 2, given by their positions in
  /// the plane, counter-clockwise.
  explicit FaceTriangulation(const std::array<Point2, 3>& corners);

  /// Adds a point that must differ from all others. Returns its index.
  int AddPoint(const GridPoint& point);
  /// Inserts an edge between two points. Returns false if another point lies on the segment or a
  /// constrained segment crosses it.
  bool AddSegment(int a, int b);
  /// Restores the Delaunay property without changing segments.
  void MakeDelaunay();

  /// Returns the corners of the triangles, counter-clockwise.
  const std::vector<std::array<int, 3>>& GetTriangles() const { return this->Triangles; }

private:
  /// The neighborhood across a side of a triangle.
  struct Side
  {
    int Twin = -1; // half-edge of the neighbor
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
  Point2 Second; // from corner 0 of the face to corner 2, scaled
  std::vector<GridPoint> Points;
  std::vector<std::array<int, 3>> Triangles;
  std::vector<int> Twins;      // per half-edge; -1 on the boundary
  std::vector<char> IsSegment; // per half-edge
  std::vector<int> Starts;     // per point, a half-edge that starts there
  int LastTriangle = 0;        // triangle of the last insertion
};

/// Returns an insertion order for FaceTriangulation::AddPoint() with constant expected time per
/// point: rounds of randomly chosen points, each twice as large as the previous one and sorted
/// along a space-filling curve (Amenta, Choi and Rote, "Incremental constructions con BRIO", 2003).
/// Deterministic. Inserting segments is fast in the order of their points.
std::vector<std::size_t> MakeInsertionOrder(const std::vector<GridPoint>& points);
}

#endif
