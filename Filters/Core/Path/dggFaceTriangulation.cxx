// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFaceTriangulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>

namespace dgg
{
namespace
{
/// Sines below this count as straight angles when triangles are improved.
constexpr double FlipTolerance = 1e-9;

/// Sign of a b - c d for numbers below 2^51 in magnitude, in three digits of 26 bits.
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
  : Corners(corners)
  , Points{ { 0, 0 }, { GridPoint::One, 0 }, { 0, GridPoint::One } }
  , Places(corners.begin(), corners.end())
  , Triangles{ { { 0, 1, 2 } } }
{
}

int FaceTriangulation::AddPoint(const GridPoint& point)
{
  const int p = static_cast<int>(this->Points.size());
  this->Points.push_back(point);
  const std::array<double, 3> b = point.GetBarycentric();
  Point2 place;
  for (int k = 0; k < 3; ++k)
  {
    place.X += b[k] * this->Corners[k].X;
    place.Y += b[k] * this->Corners[k].Y;
  }
  this->Places.push_back(place);
  // In one triangle, or on an edge of one or two.
  for (std::size_t t = this->Triangles.size(); t-- > 0;)
  {
    const std::array<int, 3> corners = this->Triangles[t];
    int sides[3];
    for (int k = 0; k < 3; ++k)
    {
      sides[k] =
        Orientation(this->Points[corners[k]], this->Points[corners[(k + 1) % 3]], this->Points[p]);
    }
    if (sides[0] < 0 || sides[1] < 0 || sides[2] < 0)
    {
      continue;
    }
    bool isFirst = true;
    for (int k = 0; k < 3; ++k)
    {
      if (sides[k] > 0)
      {
        const std::array<int, 3> piece{ { corners[k], corners[(k + 1) % 3], p } };
        if (isFirst)
        {
          this->Triangles[t] = piece;
        }
        else
        {
          this->Triangles.push_back(piece);
        }
        isFirst = false;
      }
    }
  }
  return p;
}

/// The triangle on the left of the edge from a to b, and the corner where it starts.
bool FaceTriangulation::FindEdge(int a, int b, int& triangle, int& corner) const
{
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (this->Triangles[t][k] == a && this->Triangles[t][(k + 1) % 3] == b)
      {
        triangle = static_cast<int>(t);
        corner = k;
        return true;
      }
    }
  }
  return false;
}

bool FaceTriangulation::IsSegment(int a, int b) const
{
  return std::find(this->Segments.begin(), this->Segments.end(),
           std::make_pair(std::min(a, b), std::max(a, b))) != this->Segments.end();
}

/// Whether the two triangles on the edge at a corner form a strictly convex quadrangle.
bool FaceTriangulation::CanFlip(int triangle, int corner, int& other, int& otherCorner) const
{
  const std::array<int, 3>& t = this->Triangles[triangle];
  const int a = t[corner];
  const int b = t[(corner + 1) % 3];
  if (!this->FindEdge(b, a, other, otherCorner))
  {
    return false;
  }
  const GridPoint& c = this->Points[t[(corner + 2) % 3]];
  const GridPoint& d = this->Points[this->Triangles[other][(otherCorner + 2) % 3]];
  return Orientation(c, d, this->Points[b]) > 0 && Orientation(d, c, this->Points[a]) > 0;
}

void FaceTriangulation::Flip(int triangle, int corner, int other, int otherCorner)
{
  const std::array<int, 3> t = this->Triangles[triangle];
  const int a = t[corner];
  const int b = t[(corner + 1) % 3];
  const int c = t[(corner + 2) % 3];
  const int d = this->Triangles[other][(otherCorner + 2) % 3];
  this->Triangles[triangle] = { { c, a, d } };
  this->Triangles[other] = { { d, b, c } };
}

bool FaceTriangulation::AddSegment(int a, int b)
{
  int triangle = 0;
  int corner = 0;
  if (!this->FindEdge(a, b, triangle, corner) && !this->FindEdge(b, a, triangle, corner))
  {
    // Flip the edges that cross it, those first that can be flipped (Sloan, "A fast algorithm for
    // generating constrained Delaunay triangulations", 1993).
    std::deque<std::pair<int, int>> crossing;
    auto crosses = [&](int c, int d) {
      return CrossProperly(this->Points[a], this->Points[b], this->Points[c], this->Points[d]);
    };
    for (const std::array<int, 3>& t : this->Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int c = t[k];
        const int d = t[(k + 1) % 3];
        if (c < d && crosses(c, d))
        {
          crossing.emplace_back(c, d);
        }
      }
    }
    std::size_t budget = 16 + 4 * crossing.size() * crossing.size();
    for (; !crossing.empty() && budget > 0; --budget)
    {
      const std::pair<int, int> edge = crossing.front();
      crossing.pop_front();
      int other = 0;
      int otherCorner = 0;
      if (this->IsSegment(edge.first, edge.second) ||
        !this->FindEdge(edge.first, edge.second, triangle, corner))
      {
        return false;
      }
      if (!this->CanFlip(triangle, corner, other, otherCorner))
      {
        crossing.push_back(edge);
        continue;
      }
      this->Flip(triangle, corner, other, otherCorner);
      const int c = this->Triangles[triangle][0];
      const int d = this->Triangles[triangle][2];
      if (crosses(c, d))
      {
        crossing.emplace_back(c, d);
      }
    }
    if (!this->FindEdge(a, b, triangle, corner) && !this->FindEdge(b, a, triangle, corner))
    {
      return false;
    }
  }
  if (!this->IsSegment(a, b))
  {
    this->Segments.emplace_back(std::min(a, b), std::max(a, b));
  }
  return true;
}

/// Whether the angles opposite the common edge are more than a straight angle together.
bool FaceTriangulation::IsBad(int triangle, int corner, int other, int otherCorner) const
{
  auto vectors = [&](int t, int k, Point2& u, Point2& v) {
    const Point2& apex = this->Places[this->Triangles[t][(k + 2) % 3]];
    const Point2& from = this->Places[this->Triangles[t][k]];
    const Point2& to = this->Places[this->Triangles[t][(k + 1) % 3]];
    u = Difference(from, apex);
    v = Difference(to, apex);
  };
  Point2 u1;
  Point2 v1;
  Point2 u2;
  Point2 v2;
  vectors(triangle, corner, u1, v1);
  vectors(other, otherCorner, u2, v2);
  const double sine = Cross(u1, v1) * Dot(u2, v2) + Dot(u1, v1) * Cross(u2, v2);
  const double scale = Norm(u1.X, u1.Y) * Norm(v1.X, v1.Y) * Norm(u2.X, u2.Y) * Norm(v2.X, v2.Y);
  return sine < -FlipTolerance * scale;
}

void FaceTriangulation::MakeDelaunay()
{
  const std::size_t n = this->Triangles.size();
  std::size_t budget = 16 + n * n; // rounding could turn in circles
  bool changes = true;
  while (changes && budget > 0)
  {
    changes = false;
    for (int t = 0; t < static_cast<int>(n); ++t)
    {
      for (int k = 0; k < 3 && budget > 0; ++k)
      {
        int other = 0;
        int otherCorner = 0;
        const int a = this->Triangles[t][k];
        const int b = this->Triangles[t][(k + 1) % 3];
        if (!this->IsSegment(a, b) && this->CanFlip(t, k, other, otherCorner) &&
          this->IsBad(t, k, other, otherCorner))
        {
          this->Flip(t, k, other, otherCorner);
          changes = true;
          --budget;
        }
      }
    }
  }
}
}
