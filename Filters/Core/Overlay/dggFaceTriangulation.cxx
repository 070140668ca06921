// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFaceTriangulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace dgg
{
namespace
{
/// Sines below this count as angles of pi when triangles are improved.
constexpr double FlipTolerance = 1e-9;

/// Returns the sign of a b - c d for numbers below 2^51 in magnitude, computed with three digits of
/// 26 bits.
int SignOfDifference(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d)
{
  constexpr int Bits = 26;
  constexpr std::int64_t Mask = (std::int64_t(1) << Bits) - 1;
  auto high = [](std::int64_t x) { return x >> Bits; };
  auto low = [](std::int64_t x) { return x & Mask; };
  std::int64_t units = low(a) * low(b) - low(c) * low(d);
  std::int64_t middle =
    high(a) * low(b) + low(a) * high(b) - high(c) * low(d) - low(c) * high(d) + high(units);
  const std::int64_t top = high(a) * high(b) - high(c) * high(d) + high(middle);
  if (top != 0)
  {
    return top > 0 ? 1 : -1;
  }
  return low(middle) != 0 || low(units) != 0 ? 1 : 0;
}

int Next(int h)
{
  return h % 3 == 2 ? h - 2 : h + 1;
}

int Previous(int h)
{
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// Returns an integer hash.
std::uint64_t HashOf(std::uint64_t i)
{
  i = (i + 1) * 0x9e3779b97f4a7c15ULL;
  i ^= i >> 29;
  i *= 0x6a09e667f3bcc909ULL;
  return i ^ i >> 32;
}

/// Interleaves the bits of x and y: the position along a space-filling curve (Morton order).
std::uint64_t Interleave(const GridPoint& p)
{
  auto spread = [](std::int64_t x) {
    auto bits = static_cast<std::uint64_t>(x) >> 19; // 32 of 51
    bits = (bits | bits << 16) & 0x0000ffff0000ffffULL;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ffULL;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0fULL;
    bits = (bits | bits << 2) & 0x3333333333333333ULL;
    return (bits | bits << 1) & 0x5555555555555555ULL;
  };
  return spread(p.X) | spread(p.Y) << 1;
}
}

GridPoint GridPoint::FromBarycentric(const std::array<double, 3>& b)
{
  const double scale = static_cast<double>(One) / (b[0] + b[1] + b[2]);
  GridPoint p{ std::min<std::int64_t>(One, std::llround(b[1] * scale)), 0 };
  p.Y = std::min<std::int64_t>(One - p.X, std::llround(b[2] * scale));
  if (b[0] == 0.0)
  {
    p.Y = One - p.X; // stays on its side
  }
  return p;
}

std::array<double, 3> GridPoint::GetBarycentric() const
{
  constexpr double unit = 1.0 / static_cast<double>(One);
  return { { unit * static_cast<double>(One - this->X - this->Y),
    unit * static_cast<double>(this->X), unit * static_cast<double>(this->Y) } };
}

int Orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
  return SignOfDifference(b.X - a.X, c.Y - a.Y, b.Y - a.Y, c.X - a.X);
}

bool CrossProperly(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d)
{
  return Orientation(a, b, c) * Orientation(a, b, d) < 0 &&
    Orientation(c, d, a) * Orientation(c, d, b) < 0;
}

FaceTriangulation::FaceTriangulation(const std::array<Point2, 3>& corners)
  : First(Difference(corners[1], corners[0]))
  , Second(Difference(corners[2], corners[0]))
  , Points{ { 0, 0 }, { GridPoint::One, 0 }, { 0, GridPoint::One } }
  , Triangles{ { { 0, 1, 2 } } }
  , Twins{ -1, -1, -1 }
  , IsSegment{ 0, 0, 0 }
  , Starts{ 0, 1, 2 }
{
  // Products of four lengths in grid units must stay finite. Scaling by a power of two is exact.
  int exponent = 0;
  std::frexp(std::max({ std::abs(this->First.X), std::abs(this->First.Y), std::abs(this->Second.X),
               std::abs(this->Second.Y) }),
    &exponent);
  for (double* x : { &this->First.X, &this->First.Y, &this->Second.X, &this->Second.Y })
  {
    *x = std::ldexp(*x, -exponent);
  }
}

/// Stores a triangle, and links its corners and its neighbors to it.
void FaceTriangulation::Set(int triangle, const std::array<int, 3>& corners, const Sides& sides)
{
  this->Triangles[triangle] = corners;
  for (int k = 0; k < 3; ++k)
  {
    const int h = 3 * triangle + k;
    this->Starts[corners[k]] = h;
    this->Glue(h, sides[k].Twin);
    this->IsSegment[h] = sides[k].IsSegment;
  }
}

int FaceTriangulation::NewTriangle()
{
  this->Triangles.push_back({ { 0, 0, 0 } });
  this->Twins.insert(this->Twins.end(), 3, -1);
  this->IsSegment.insert(this->IsSegment.end(), 3, 0);
  return static_cast<int>(this->Triangles.size()) - 1;
}

void FaceTriangulation::Glue(int h, int twin)
{
  this->Twins[h] = twin;
  if (twin >= 0)
  {
    this->Twins[twin] = h;
  }
}

int FaceTriangulation::AddPoint(const GridPoint& point)
{
  const int p = static_cast<int>(this->Points.size());
  this->Points.push_back(point);
  this->Starts.push_back(-1);
  const int t = this->Locate(point);
  for (int k = 0; k < 3; ++k)
  {
    const int h = 3 * t + k;
    if (Orientation(this->Points[this->Origin(h)], this->Points[this->Destination(h)], point) == 0)
    {
      this->SplitEdge(h, p);
      return p;
    }
  }
  this->SplitTriangle(t, p);
  return p;
}

/// Returns a triangle that contains a point, walking from the last triangle across edges that
/// separate it from the point.
int FaceTriangulation::Locate(const GridPoint& point)
{
  const int n = static_cast<int>(this->Triangles.size());
  int t = this->LastTriangle < n ? this->LastTriangle : 0;
  int entry = -1;
  // Without the Delaunay property the walk could cycle.
  for (int steps = 0; steps < n + 16; ++steps)
  {
    int exit = -1;
    for (int i = 0; i < 3 && exit < 0; ++i)
    {
      const int h = 3 * t + (i + steps) % 3;
      if (h != entry &&
        Orientation(this->Points[this->Origin(h)], this->Points[this->Destination(h)], point) < 0)
      {
        exit = h;
      }
    }
    if (exit < 0)
    {
      this->LastTriangle = t;
      return t;
    }
    entry = this->Twins[exit];
    t = entry / 3;
  }
  for (t = 0; t < n - 1 && !this->IsIn(t, point); ++t)
  {
  }
  this->LastTriangle = t;
  return t;
}

bool FaceTriangulation::IsIn(int triangle, const GridPoint& point) const
{
  bool isIn = true;
  for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
  {
    isIn = isIn &&
      Orientation(this->Points[this->Origin(h)], this->Points[this->Destination(h)], point) >= 0;
  }
  return isIn;
}

void FaceTriangulation::SplitTriangle(int t, int p)
{
  const std::array<int, 3> corners = this->Triangles[t];
  const Sides sides = this->SidesOf(t);
  const std::array<int, 3> pieces{ { t, this->NewTriangle(), this->NewTriangle() } };
  std::vector<int> edges;
  for (int k = 0; k < 3; ++k)
  {
    const int next = pieces[(k + 1) % 3];
    const int previous = pieces[(k + 2) % 3];
    this->Set(pieces[k], { { corners[k], corners[(k + 1) % 3], p } },
      { { sides[k], { 3 * next + 2, 0 }, { 3 * previous + 1, 0 } } });
    edges.push_back(3 * pieces[k]);
  }
  this->Improve(edges);
}

/// Splits the one or two triangles on an edge at a point of the edge.
void FaceTriangulation::SplitEdge(int h, int p)
{
  const int twin = this->Twins[h];
  const char isSegment = this->IsSegment[h];
  std::vector<int> edges;
  // For each triangle, the half of the edge with which it starts and the one with which it ends.
  std::array<int, 2> firsts{ { -1, -1 } };
  std::array<int, 2> seconds{ { -1, -1 } };
  for (int i = 0; i < (twin < 0 ? 1 : 2); ++i)
  {
    const int side = i == 0 ? h : twin;
    const int t = side / 3;
    const int k = side % 3;
    const std::array<int, 3> corners = this->Triangles[t];
    const Sides sides = this->SidesOf(t);
    const int a = corners[k];
    const int b = corners[(k + 1) % 3];
    const int c = corners[(k + 2) % 3];
    const int more = this->NewTriangle();
    this->Set(
      t, { { c, a, p } }, { { sides[(k + 2) % 3], { -1, isSegment }, { 3 * more + 1, 0 } } });
    this->Set(
      more, { { b, c, p } }, { { sides[(k + 1) % 3], { 3 * t + 2, 0 }, { -1, isSegment } } });
    firsts[i] = 3 * t + 1;
    seconds[i] = 3 * more + 2;
    edges.push_back(3 * t);
    edges.push_back(3 * more);
  }
  if (twin >= 0)
  {
    this->Glue(firsts[0], seconds[1]);
    this->Glue(firsts[1], seconds[0]);
  }
  this->Improve(edges);
}

FaceTriangulation::Sides FaceTriangulation::SidesOf(int triangle) const
{
  Sides sides;
  for (int k = 0; k < 3; ++k)
  {
    sides[k] = { this->Twins[3 * triangle + k], this->IsSegment[3 * triangle + k] };
  }
  return sides;
}

/// Returns the half-edge from a to b, otherwise that from b to a; -1 if there is neither.
int FaceTriangulation::FindEdge(int a, int b) const
{
  const int start = this->Starts[a];
  int h = start;
  do // counter-clockwise
  {
    if (this->Destination(h) == b)
    {
      return h;
    }
    const int last = Previous(h);
    if (this->Origin(last) == b && this->Twins[last] < 0)
    {
      return last;
    }
    h = this->Twins[last];
  } while (h >= 0 && h != start);
  for (h = h < 0 ? this->Twins[start] : -1; h >= 0; h = this->Twins[h]) // then clockwise
  {
    h = Next(h);
    if (this->Destination(h) == b)
    {
      return h;
    }
  }
  return -1;
}

/// Returns true if the two triangles on an edge form a strictly convex quadrilateral.
bool FaceTriangulation::CanFlip(int h) const
{
  const int twin = this->Twins[h];
  if (twin < 0)
  {
    return false;
  }
  const GridPoint& c = this->Points[this->Origin(Previous(h))];
  const GridPoint& d = this->Points[this->Origin(Previous(twin))];
  return Orientation(c, d, this->Points[this->Destination(h)]) > 0 &&
    Orientation(d, c, this->Points[this->Origin(h)]) > 0;
}

/// Replaces an edge by the other diagonal of its two triangles, where it becomes half-edge 2 of
/// both.
void FaceTriangulation::Flip(int h)
{
  const int twin = this->Twins[h];
  const int t = h / 3;
  const int other = twin / 3;
  const int a = this->Origin(h);
  const int b = this->Destination(h);
  const int c = this->Origin(Previous(h));
  const int d = this->Origin(Previous(twin));
  const Sides sides = this->SidesOf(t);
  const Sides otherSides = this->SidesOf(other);
  this->Set(t, { { c, a, d } },
    { { sides[Previous(h) % 3], otherSides[Next(twin) % 3], { 3 * other + 2, 0 } } });
  this->Set(other, { { d, b, c } },
    { { otherSides[Previous(twin) % 3], sides[Next(h) % 3], { 3 * t + 2, 0 } } });
}

/// Finds the edges that a segment crosses, from its start on. Returns false if the segment passes
/// through a point or crosses a constrained segment.
bool FaceTriangulation::FindCrossed(int a, int b, std::deque<std::pair<int, int>>& crossed) const
{
  const GridPoint& from = this->Points[a];
  const GridPoint& to = this->Points[b];
  auto sideOf = [&](int p) { return Orientation(from, to, this->Points[p]); };
  // The triangle at a that the segment leaves through the opposite side.
  const int start = this->Starts[a];
  int exit = -1;
  auto look = [&](int h) {
    const int opposite = Next(h);
    if (sideOf(this->Origin(opposite)) < 0 && sideOf(this->Destination(opposite)) > 0)
    {
      exit = opposite;
    }
  };
  int h = start;
  do
  {
    look(h);
    h = this->Twins[Previous(h)];
  } while (exit < 0 && h >= 0 && h != start);
  for (h = h < 0 && exit < 0 ? this->Twins[start] : -1; h >= 0 && exit < 0; h = this->Twins[h])
  {
    h = Next(h);
    look(h);
  }
  while (exit >= 0)
  {
    if (this->IsSegment[exit] || this->Twins[exit] < 0)
    {
      return false;
    }
    crossed.emplace_back(this->Origin(exit), this->Destination(exit));
    const int entry = this->Twins[exit];
    const int apex = this->Origin(Previous(entry));
    if (apex == b)
    {
      return true;
    }
    const int side = sideOf(apex);
    if (side == 0)
    {
      return false;
    }
    exit = side > 0 ? Next(entry) : Previous(entry);
  }
  return false;
}

bool FaceTriangulation::AddSegment(int a, int b)
{
  int h = this->FindEdge(a, b);
  if (h < 0)
  {
    // Flip the edges that cross the segment; edges that cannot be flipped yet are postponed (Sloan,
    // "A fast algorithm for generating constrained Delaunay triangulations", 1993).
    std::deque<std::pair<int, int>> crossing;
    if (!this->FindCrossed(a, b, crossing))
    {
      return false;
    }
    auto crosses = [&](int c, int d) {
      return CrossProperly(this->Points[a], this->Points[b], this->Points[c], this->Points[d]);
    };
    std::vector<std::pair<int, int>> changed;
    std::size_t budget = 16 + 4 * crossing.size() * crossing.size();
    for (; !crossing.empty() && budget > 0; --budget)
    {
      const std::pair<int, int> edge = crossing.front();
      crossing.pop_front();
      h = this->FindEdge(edge.first, edge.second);
      if (!this->CanFlip(h))
      {
        crossing.push_back(edge);
        continue;
      }
      const int c = this->Origin(Previous(h));
      const int d = this->Origin(Previous(this->Twins[h]));
      this->Flip(h);
      if (crosses(c, d))
      {
        crossing.emplace_back(c, d);
      }
      else
      {
        changed.emplace_back(c, d);
      }
    }
    h = this->FindEdge(a, b);
    if (h < 0)
    {
      return false;
    }
    this->Fix(h);
    std::vector<int> edges;
    edges.reserve(changed.size());
    for (const std::pair<int, int>& edge : changed)
    {
      edges.push_back(this->FindEdge(edge.first, edge.second));
    }
    this->Improve(edges);
    return true;
  }
  this->Fix(h);
  return true;
}

void FaceTriangulation::Fix(int h)
{
  this->IsSegment[h] = 1;
  if (this->Twins[h] >= 0)
  {
    this->IsSegment[this->Twins[h]] = 1;
  }
}

/// Returns the vector from one point to another in the plane of the face, in grid units; accurate
/// to the last digits however close they are.
Point2 FaceTriangulation::Way(int from, int to) const
{
  const auto x = static_cast<double>(this->Points[to].X - this->Points[from].X);
  const auto y = static_cast<double>(this->Points[to].Y - this->Points[from].Y);
  return { x * this->First.X + y * this->Second.X, x * this->First.Y + y * this->Second.Y };
}

/// Returns true if the sum of the angles opposite to the edge exceeds pi.
bool FaceTriangulation::IsBad(int h) const
{
  auto vectors = [&](int e, Point2& u, Point2& v) {
    const int apex = this->Origin(Previous(e));
    u = this->Way(apex, this->Origin(e));
    v = this->Way(apex, this->Destination(e));
  };
  Point2 u1;
  Point2 v1;
  Point2 u2;
  Point2 v2;
  vectors(h, u1, v1);
  vectors(this->Twins[h], u2, v2);
  const double sine = Cross(u1, v1) * Dot(u2, v2) + Dot(u1, v1) * Cross(u2, v2);
  const double scale = Norm(u1.X, u1.Y) * Norm(v1.X, v1.Y) * Norm(u2.X, u2.Y) * Norm(v2.X, v2.Y);
  return sine < -FlipTolerance * scale;
}

void FaceTriangulation::MakeDelaunay()
{
  std::vector<int> edges;
  for (int h = 0; h < static_cast<int>(this->Twins.size()); ++h)
  {
    if (h < this->Twins[h])
    {
      edges.push_back(h);
    }
  }
  this->Improve(edges);
}

/// Flips unconstrained edges that are not Delaunay, and rechecks the neighbors of each of them.
void FaceTriangulation::Improve(std::vector<int>& edges)
{
  std::size_t budget = 64 * this->Triangles.size(); // rounding could cause cycles
  while (!edges.empty())
  {
    const int h = edges.back();
    edges.pop_back();
    if (this->IsSegment[h] || !this->CanFlip(h) || !this->IsBad(h))
    {
      continue;
    }
    if (budget-- == 0)
    {
      return;
    }
    const int t = h / 3;
    const int other = this->Twins[h] / 3;
    this->Flip(h);
    for (const int e : { 3 * t, 3 * t + 1, 3 * other, 3 * other + 1 })
    {
      edges.push_back(e);
    }
  }
}

std::vector<std::size_t> MakeInsertionOrder(const std::vector<GridPoint>& points)
{
  struct Key
  {
    int Round;
    std::uint64_t Curve;
    std::size_t Index;
    bool operator<(const Key& other) const
    {
      return std::tie(this->Round, this->Curve, this->Index) <
        std::tie(other.Round, other.Curve, other.Index);
    }
  };
  std::vector<Key> keys;
  keys.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    // The last round has half of the points, the round before a quarter, and so on.
    int round = 0;
    for (std::uint64_t bits = HashOf(i); (bits & 1) != 0 && round > -60; bits >>= 1)
    {
      --round;
    }
    keys.push_back({ round, Interleave(points[i]), i });
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> order;
  order.reserve(keys.size());
  for (const Key& key : keys)
  {
    order.push_back(key.Index);
  }
  return order;
}
}
