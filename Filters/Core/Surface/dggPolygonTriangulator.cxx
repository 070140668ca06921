// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPolygonTriangulator.h"

#include "dggBarycentric.h"
#include "dggBoxTree.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <queue>
#include <utility>

namespace dgg
{
namespace
{
/// A polygon in the plane, counterclockwise, that loses its corners one by one.
class EarCutter
{
public:
  explicit EarCutter(const std::vector<Point2>& points)
    : Points(points)
    , Links(points.size())
    , Versions(points.size(), 0)
    , Remaining(static_cast<Id>(points.size()))
  {
    const auto n = static_cast<Id>(points.size());
    for (Id i = 0; i < n; ++i)
    {
      this->Links[i] = { (i + n - 1) % n, (i + 1) % n };
    }
  }

  /// Appends three indices per triangle. Returns false if corners remain that cannot be cut off.
  bool Run(std::vector<Id>& triangles)
  {
    const auto n = static_cast<Id>(this->Points.size());
    this->RemoveSpikes(triangles);
    if (this->Remaining > 3 && !this->TurnsOnce())
    {
      return false;
    }
    this->CollectReflex();
    for (Id i = 0; i < n; ++i)
    {
      this->Push(i);
    }
    std::vector<Id> blocked; // convex, but not ears when they were examined
    bool hasChanged = false;
    while (this->Remaining > 3)
    {
      if (this->Queue.empty())
      {
        if (!hasChanged)
        {
          return false;
        }
        hasChanged = false;
        std::for_each(blocked.begin(), blocked.end(), [this](Id i) { this->Push(i); });
        blocked.clear();
        continue;
      }
      const Entry entry = this->Queue.top();
      this->Queue.pop();
      const Id i = entry.Corner;
      if (entry.Version != this->Versions[i])
      {
        continue;
      }
      if (!this->IsEmpty(i))
      {
        blocked.push_back(i);
        continue;
      }
      const auto [before, after] = this->Links[i];
      this->Remove(i, triangles);
      hasChanged = true;
      this->Push(before);
      this->Push(after);
    }
    const auto last = static_cast<Id>(std::find_if(this->Versions.begin(), this->Versions.end(),
                                        [](Id version) { return version != Removed; }) -
      this->Versions.begin());
    const auto [before, after] = this->Links[last];
    triangles.insert(triangles.end(), { before, last, after });
    return this->GetArea(before, last, after) > -Rounding;
  }

private:
  static constexpr Id Removed = -1;
  static constexpr double Rounding = 1e-12; // rounding of areas; the extent of the polygon is 1
  static constexpr double SmallestEdge = 1e-9;

  struct Entry
  {
    double Measure; // squared perimeter per area; smaller is better
    Id Corner;
    Id Version;
    bool operator<(const Entry& other) const // the best is on top
    {
      return std::make_pair(this->Measure, this->Corner) >
        std::make_pair(other.Measure, other.Corner);
    }
  };

  void Remove(Id i, std::vector<Id>& triangles)
  {
    const auto [before, after] = this->Links[i];
    triangles.insert(triangles.end(), { before, i, after });
    this->Links[before].second = after;
    this->Links[after].first = before;
    this->Versions[i] = Removed;
    --this->Remaining;
  }

  /// Removes corners at edges of zero length and at spikes, where the boundary turns back. Their
  /// triangles have no area, and the angles there are undefined.
  void RemoveSpikes(std::vector<Id>& triangles)
  {
    Id i = 0;
    for (Id unchanged = 0; this->Remaining > 3 && unchanged < this->Remaining; ++unchanged)
    {
      const auto [before, after] = this->Links[i];
      const Point2 in = Difference(this->Points[i], this->Points[before]);
      const Point2 out = Difference(this->Points[after], this->Points[i]);
      const bool turnsBack = Dot(in, out) < 0.0 && std::abs(Cross(in, out)) <= Rounding;
      if (turnsBack || Distance(this->Points[i], this->Points[before]) <= SmallestEdge)
      {
        this->Remove(i, triangles);
        unchanged = -2; // the neighbors have changed: examine both again
        i = before;
        continue;
      }
      i = after;
    }
  }

  double GetArea(Id a, Id b, Id c) const
  {
    return Cross(
      Difference(this->Points[b], this->Points[a]), Difference(this->Points[c], this->Points[a]));
  }

  /// Returns true if the boundary makes one counterclockwise turn, as for every simple polygon.
  bool TurnsOnce() const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      const auto [before, after] = this->Links[i];
      const Point2 in = Difference(this->Points[i], this->Points[before]);
      const Point2 out = Difference(this->Points[after], this->Points[i]);
      sum += this->Versions[i] == Removed ? 0.0 : std::atan2(Cross(in, out), Dot(in, out));
    }
    return std::abs(sum - 2.0 * Pi) < 1.0;
  }

  /// Queues a corner, if it is convex and still there, with the shape of its triangle.
  void Push(Id i)
  {
    if (this->Versions[i] == Removed)
    {
      return;
    }
    ++this->Versions[i];
    const auto [before, after] = this->Links[i];
    const double area = this->GetArea(before, i, after);
    if (area > 0.0)
    {
      const double perimeter = Distance(this->Points[before], this->Points[i]) +
        Distance(this->Points[i], this->Points[after]) +
        Distance(this->Points[after], this->Points[before]);
      this->Queue.push({ perimeter * perimeter / area, i, this->Versions[i] });
    }
  }

  /// Finds the corners that are not convex: only these can be in the triangle of another corner of
  /// a simple polygon.
  void CollectReflex()
  {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      const auto corner = static_cast<Id>(i);
      const auto [before, after] = this->Links[i];
      if (this->Versions[i] != Removed && !(this->GetArea(before, corner, after) > 0.0))
      {
        const std::array<double, 3> point{ { this->Points[i].X, this->Points[i].Y, 0.0 } };
        boxes.push_back({ point, point });
        this->Reflex.push_back(corner);
      }
    }
    this->ReflexTree = BoxTree(boxes);
  }

  /// Returns true if no other corner is in the triangle of a corner. Corners at the same point as
  /// a corner of the triangle do not count: bridges to holes pass such points twice.
  bool IsEmpty(Id i) const
  {
    const auto [a, c] = this->Links[i];
    const std::array<Id, 3> corners{ { a, i, c } };
    bool isEmpty = true;
    // True if part of a box may be on the inner side of all edges.
    const auto isRelevant = [&](const Box& box) {
      for (int k = 0; k < 3 && isEmpty; ++k)
      {
        const Point2& p = this->Points[corners[k]];
        const Point2 edge = Difference(this->Points[corners[(k + 1) % 3]], p);
        const Point2 innermost{ edge.Y < 0.0 ? box.High[0] : box.Low[0],
          edge.X > 0.0 ? box.High[1] : box.Low[1] };
        if (Cross(edge, Difference(innermost, p)) < 0.0)
        {
          return false;
        }
      }
      return isEmpty;
    };
    this->ReflexTree.ForEach(isRelevant, [&](Id element) {
      const Id k = this->Reflex[element];
      const bool isCorner = std::any_of(corners.begin(), corners.end(),
        [&](Id corner) { return Distance(this->Points[corner], this->Points[k]) == 0.0; });
      if (this->Versions[k] != Removed && !isCorner && this->GetArea(a, i, k) >= 0.0 &&
        this->GetArea(i, c, k) >= 0.0 && this->GetArea(c, a, k) >= 0.0)
      {
        isEmpty = false;
      }
    });
    return isEmpty;
  }

  const std::vector<Point2>& Points;
  std::vector<std::pair<Id, Id>> Links; // corner before and after
  std::vector<Id> Versions;             // of the triangle of a corner
  Id Remaining;
  std::priority_queue<Entry> Queue;
  std::vector<Id> Reflex;
  BoxTree ReflexTree; // over Reflex
};
}

//------------------------------------------------------------------------------
Id PolygonTriangulator::Triangulate(const std::vector<Id>& polygon, std::vector<Id>& triangles)
{
  const std::size_t before = triangles.size();
  this->Corners.clear();
  std::unique_copy(polygon.begin(), polygon.end(), std::back_inserter(this->Corners));
  while (this->Corners.size() > 1 && this->Corners.back() == this->Corners.front())
  {
    this->Corners.pop_back();
  }
  const auto& c = this->Corners;
  if (c.size() == 3)
  {
    Append(c[0], c[1], c[2], triangles);
  }
  else if (c.size() == 4)
  {
    this->Normalize();
    this->CutQuad(triangles);
  }
  else if (c.size() > 4)
  {
    this->Normalize();
    if (!this->CutEars(triangles))
    {
      ++this->NumberOfFans;
      this->CutFan(triangles);
    }
  }
  return static_cast<Id>((triangles.size() - before) / 3);
}

//------------------------------------------------------------------------------
/// Sets Positions, so that no product of them overflows or vanishes.
void PolygonTriangulator::Normalize()
{
  const double* origin = this->Points + 3 * static_cast<std::size_t>(this->Corners[0]);
  this->Positions.clear();
  double extent = 0.0;
  for (const Id corner : this->Corners)
  {
    const double* p = this->Points + 3 * static_cast<std::size_t>(corner);
    this->Positions.push_back({ { p[0] - origin[0], p[1] - origin[1], p[2] - origin[2] } });
    for (const double x : this->Positions.back())
    {
      extent = std::max(extent, std::abs(x));
    }
  }
  if (extent > 0.0)
  {
    for (Vector& v : this->Positions)
    {
      std::transform(v.begin(), v.end(), v.begin(), [extent](double x) { return x / extent; });
    }
  }
}

//------------------------------------------------------------------------------
void PolygonTriangulator::CutQuad(std::vector<Id>& triangles)
{
  const auto& c = this->Corners;
  if (c[0] == c[2] || c[1] == c[3])
  {
    return; // folded onto itself: no area
  }
  // A diagonal lies inside when the triangles on its two sides have similar normals.
  const std::vector<Vector>& p = this->Positions;
  const auto normal = [&p](int i, int j, int k) { return Cross(p[j] - p[i], p[k] - p[i]); };
  const Vector d02 = p[2] - p[0];
  const Vector d13 = p[3] - p[1];
  const double across02 = Dot(normal(0, 1, 2), normal(0, 2, 3));
  const double across13 = Dot(normal(0, 1, 3), normal(1, 2, 3));
  const bool inside02 = across02 > 0.0;
  const bool inside13 = across13 > 0.0;
  if (across02 < 0.0 && across13 < 0.0)
  {
    // The quad is folded sharply or crosses itself. In the second case, its projection onto the
    // plane of CutEars() crosses itself, too.
    const Vector all = Cross(d02, d13);
    const auto isOutside = [&](const Vector& a, const Vector& b) {
      return Dot(all, a) * Dot(all, b) <= 0.0;
    };
    this->NumberOfFans +=
      isOutside(normal(0, 1, 2), normal(0, 2, 3)) && isOutside(normal(0, 1, 3), normal(1, 2, 3))
      ? 1
      : 0;
  }
  // Of two inner diagonals the shorter one is used. A product of 0 cuts off a spike without area.
  if (inside02 && inside13 ? Dot(d13, d13) < Dot(d02, d02) : across13 > across02 && across13 >= 0.0)
  {
    Append(c[0], c[1], c[3], triangles);
    Append(c[1], c[2], c[3], triangles);
  }
  else
  {
    Append(c[0], c[1], c[2], triangles);
    Append(c[0], c[2], c[3], triangles);
  }
}

//------------------------------------------------------------------------------
bool PolygonTriangulator::CutEars(std::vector<Id>& triangles)
{
  // The plane of the polygon: its normal is the sum of cross products (Newell's method).
  const std::vector<Vector>& p = this->Positions;
  Vector normal{};
  for (std::size_t i = 1; i + 1 < p.size(); ++i)
  {
    const Vector n = Cross(p[i], p[i + 1]); // the first corner is the origin
    std::transform(n.begin(), n.end(), normal.begin(), normal.begin(), std::plus<double>());
  }
  const auto smallest = std::min_element(
    normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  Vector axis{};
  axis[static_cast<std::size_t>(smallest - normal.begin())] = 1.0;
  const Vector x = Cross(axis, normal);
  const Vector y = Cross(normal, x);
  const double xLength = std::sqrt(Dot(x, x));
  const double yLength = std::sqrt(Dot(y, y));
  if (!(xLength > 0.0 && yLength > 0.0))
  {
    return false;
  }
  std::vector<Point2> points;
  points.reserve(p.size());
  for (const Vector& position : p)
  {
    points.push_back({ Dot(x, position) / xLength, Dot(y, position) / yLength });
  }
  std::vector<Id> ears;
  if (!EarCutter(points).Run(ears))
  {
    return false;
  }
  const auto& c = this->Corners;
  for (std::size_t i = 0; i < ears.size(); i += 3)
  {
    Append(c[ears[i]], c[ears[i + 1]], c[ears[i + 2]], triangles);
  }
  return true;
}

//------------------------------------------------------------------------------
void PolygonTriangulator::CutFan(std::vector<Id>& triangles) const
{
  const auto& c = this->Corners;
  for (std::size_t i = 1; i + 1 < c.size(); ++i)
  {
    Append(c[0], c[i], c[i + 1], triangles);
  }
}
}
