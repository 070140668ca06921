// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangulates one triangle with points and segments in it. Internal.
#ifndef dggFaceTriangulation_h
#define dggFaceTriangulation_h

#include "dggUnfolding.h" // for Point2

#include <array>   // for triangles and barycentric coordinates
#include <cstdint> // for grid coordinates
#include <utility> // for segments
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

/// A constrained triangulation, Delaunay in the plane of the face where the segments allow it.
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
  /// Improve the triangles without touching segments.
  void MakeDelaunay();

  /// Counter-clockwise.
  const std::vector<std::array<int, 3>>& GetTriangles() const { return this->Triangles; }

private:
  bool FindEdge(int a, int b, int& triangle, int& corner) const;
  bool IsSegment(int a, int b) const;
  bool CanFlip(int triangle, int corner, int& other, int& otherCorner) const;
  void Flip(int triangle, int corner, int other, int otherCorner);
  bool IsBad(int triangle, int corner, int other, int otherCorner) const;

  std::array<Point2, 3> Corners;
  std::vector<GridPoint> Points;
  std::vector<Point2> Places;
  std::vector<std::array<int, 3>> Triangles;
  std::vector<std::pair<int, int>> Segments; // smaller index first
};
}

#endif
