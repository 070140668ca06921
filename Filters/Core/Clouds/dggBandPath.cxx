// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBandPath.h"

#include "dggBandSizes.h"
#include "dggCloudFrame.h"
#include "dggLocalFit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace dgg
{
namespace
{
/// Longest step between points of a path, in spacings of the cloud.
constexpr double StepBySpacing = 0.9;
/// Radius, in spacings, of the neighborhood from which the surface at a point and the boundary of
/// the cloud are determined.
constexpr double FitBySpacing = 3.0;
/// Fraction of the step toward the midpoint of its neighbors that a point moves in one round.
constexpr double Damping = 0.7;
constexpr std::size_t LongestStride = 8;
constexpr int MaximumRounds = 200;
/// Number of rounds between two checks of the length.
constexpr int RoundsPerCheck = 5;
/// Smallest relative decrease of the length between two checks, below which the relaxation ends.
constexpr double SmallestDecrease = 1e-5;
constexpr int MaximumPointsPerGraphEdge = 1000;

/// Returns the component of a vector perpendicular to a normal, which may be 0.
Point3 AlongPlane(const Point3& vector, const Point3& normal)
{
  return vector - Dot(vector, normal) * normal;
}

double LengthOf(const std::vector<Point3>& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += Norm(points[i] - points[i - 1]);
  }
  return length;
}
}

/// Relaxation of one path
class BandPathShortener::Relaxation
{
public:
  explicit Relaxation(const BandPathShortener& tables)
    : Tables(tables)
  {
  }

  void Add(const Point3& point, Id owner)
  {
    this->Points.push_back(point);
    this->Owners.push_back(owner);
  }

  /// Adds the points of the cloud along an edge, or along the segment to the end of the path.
  void AddGraphEdge(const Point3& to, Id owner)
  {
    const Point3 from = this->Points.back();
    const Id first = this->Owners.back();
    const double step = StepBySpacing * std::max(this->SpacingAt(first), this->SpacingAt(owner));
    const int count = step > 0.0 ? static_cast<int>(std::min<double>(
                                     MaximumPointsPerGraphEdge, std::ceil(Norm(to - from) / step)))
                                 : 1;
    for (int i = 1; i < count; ++i)
    {
      const Point3 position = from + (static_cast<double>(i) / count) * (to - from);
      const Id nearest = this->FindOwner(this->Owners.back(), position);
      if (nearest != this->Owners.back() && nearest != owner)
      {
        this->Add(dgg::PointAt(this->Tables.Points, nearest), nearest);
      }
    }
    this->Add(to, owner);
  }

  /// Relaxes the path. Returns false if the callback requests an abort.
  bool Run(const ProgressCallback& progress)
  {
    for (std::size_t i = 1; i + 1 < this->Points.size(); ++i)
    {
      this->MoveTo(i, this->Points[i]);
    }
    std::vector<Point3> best = this->Points;
    double shortest = LengthOf(best);
    // Large strides straighten long bends in few rounds, but cause kinks next to gaps and
    // boundaries. Therefore the stride starts large and becomes 1 once the length no longer
    // decreases.
    std::size_t longest = LongestStride;
    for (int round = 1; round <= MaximumRounds && longest > 0; ++round)
    {
      for (std::size_t stride = longest; stride >= 1; stride /= 2)
      {
        if (progress && !progress(static_cast<double>(round) / (MaximumRounds + 1)))
        {
          return false;
        }
        for (std::size_t i = 1; i + 1 < this->Points.size(); ++i)
        {
          const std::size_t k = std::min({ stride, i, this->Points.size() - 1 - i });
          const Point3 middle = 0.5 * (this->Points[i - k] + this->Points[i + k]);
          this->MoveTo(i, this->Points[i] + Damping * (middle - this->Points[i]));
        }
      }
      if (round % RoundsPerCheck == 0)
      {
        const double length = LengthOf(this->Points);
        if (length > (1.0 - SmallestDecrease) * shortest)
        {
          longest = longest > 1 ? 1 : 0;
        }
        if (length < shortest)
        {
          best = this->Points;
          shortest = length;
        }
      }
    }
    this->Points.swap(best);
    return true;
  }

  std::vector<Point3> Points;

private:
  /// Moves a point to the surface near a position, toward the nearest point of the cloud, unless
  /// the move leads beyond the boundary of the cloud or across a gap.
  void MoveTo(std::size_t i, const Point3& position)
  {
    const Id owner = this->FindOwner(this->Owners[i], position);
    const double spacing = this->SpacingAt(owner);
    const double radius = FitBySpacing * spacing;
    this->Around.clear();
    const auto add = [&](Id v) {
      const Point3 point = dgg::PointAt(this->Tables.Points, v);
      const Point3 d = point - position;
      if (Dot(d, d) <= radius * radius)
      {
        this->Around.push_back(point);
      }
    };
    add(owner);
    const GraphView& graph = this->Tables.Graph;
    for (Offset e = graph.Offsets[owner]; e < graph.Offsets[owner + 1]; ++e)
    {
      add(graph.Targets[e]);
    }
    const LocalFit fit = FitSurface(position, this->Around.data(), this->Around.size());
    Point3 moved = position;
    if (Norm(fit.ToSurface) <= radius)
    {
      moved = moved + fit.ToSurface;
    }
    const Point3 offset = AlongPlane(dgg::PointAt(this->Tables.Points, owner) - moved, fit.Normal);
    moved = moved + std::max(0.0, 1.0 - spacing / Norm(offset)) * offset;
    const double ball = this->Tables.Radii[owner];
    if (this->IsNearCloud(moved, ball) &&
      this->IsNearCloud(0.5 * (moved + this->Points[i - 1]), ball) &&
      this->IsNearCloud(0.5 * (moved + this->Points[i + 1]), ball) &&
      !this->IsOutward(moved, moved - this->Points[i], fit.Normal))
    {
      this->Points[i] = moved;
      this->Owners[i] = owner;
    }
  }

  /// Returns true if one of the points around a move (Around) is within a radius of a position.
  bool IsNearCloud(const Point3& position, double radius) const
  {
    return std::any_of(this->Around.begin(), this->Around.end(), [&](const Point3& point) {
      const Point3 d = point - position;
      return Dot(d, d) <= radius * radius;
    });
  }

  /// Returns true if a position is outside the convex hull of the surrounding points, seen along
  /// the normal, and the move to this position points away from the hull.
  bool IsOutward(const Point3& position, const Point3& move, const Point3& normal)
  {
    const Point3 x = AlongPlane(move, normal);
    const Point3 y = Cross(normal, x);
    unsigned quadrants = 0;
    for (const Point3& point : this->Around)
    {
      const Point3 d = point - position;
      quadrants |= 1u << (2 * (Dot(d, x) > 0.0) + (Dot(d, y) > 0.0));
    }
    if (quadrants == 15) // points in all quadrants: the position is surrounded
    {
      return false;
    }
    this->Angles.clear();
    for (const Point3& point : this->Around)
    {
      const Point3 d = point - position;
      this->Angles.push_back(std::atan2(Dot(d, y), Dot(d, x)));
    }
    std::sort(this->Angles.begin(), this->Angles.end());
    this->Angles.push_back(this->Angles.front() + 2.0 * Pi);
    for (std::size_t k = 1; k < this->Angles.size(); ++k)
    {
      if (this->Angles[k] - this->Angles[k - 1] > Pi)
      {
        return std::cos(0.5 * (this->Angles[k] + this->Angles[k - 1])) > 0.0;
      }
    }
    return false;
  }

  /// Walks along edges to the cloud point nearest to a position, and returns its id.
  Id FindOwner(Id owner, const Point3& position) const
  {
    const auto measure = [&](Id v) {
      const Point3 d = dgg::PointAt(this->Tables.Points, v) - position;
      return Dot(d, d);
    };
    const GraphView& graph = this->Tables.Graph;
    double least = measure(owner);
    for (;;)
    {
      Id next = owner;
      for (Offset e = graph.Offsets[owner]; e < graph.Offsets[owner + 1]; ++e)
      {
        const double distance = measure(graph.Targets[e]);
        if (distance < least)
        {
          least = distance;
          next = graph.Targets[e];
        }
      }
      if (next == owner)
      {
        return owner;
      }
      owner = next;
    }
  }

  double SpacingAt(Id v) const { return this->Tables.Radii[v] / AutomaticBallBySpacing; }

  const BandPathShortener& Tables;
  std::vector<Id> Owners;     ///< per point, the nearest cloud point
  std::vector<Point3> Around; ///< cloud points around the position of a move
  std::vector<double> Angles; ///< directions to the points in Around, radians
};

BandPathShortener::BandPathShortener(
  const double* points, const GraphView& graph, const double* radii)
  : Points(points)
  , Graph(graph)
  , Radii(radii)
{
}

Status BandPathShortener::Shorten(const std::vector<Id>& vertices, const Point3* start,
  const Point3* end, BandPath& path, const ProgressCallback& progress) const
{
  path = BandPath();
  if (vertices.empty())
  {
    return Status::Success();
  }
  for (const Id v : vertices)
  {
    if (v < 0 || v >= this->Graph.NumberOfVertices)
    {
      return InvalidInput("Point ", v, " of the path does not exist: the graph has ",
        this->Graph.NumberOfVertices, " vertices");
    }
  }
  Relaxation relaxation(*this);
  relaxation.Add(start ? *start : dgg::PointAt(this->Points, vertices.front()), vertices.front());
  for (std::size_t i = start ? 0 : 1; i + (end ? 0 : 1) < vertices.size(); ++i)
  {
    relaxation.AddGraphEdge(dgg::PointAt(this->Points, vertices[i]), vertices[i]);
  }
  if (start || end || vertices.size() > 1)
  {
    relaxation.AddGraphEdge(
      end ? *end : dgg::PointAt(this->Points, vertices.back()), vertices.back());
  }
  if (!relaxation.Run(progress))
  {
    return Status::Abort();
  }
  path.Points.swap(relaxation.Points);
  path.Vertices.assign(path.Points.size(), NoId);
  path.Vertices.front() = start ? NoId : vertices.front();
  path.Vertices.back() = end ? path.Vertices.back() : vertices.back();
  path.Length = LengthOf(path.Points);
  return Status::Success();
}
}
