// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLevelTurns.h"

#include "dggFieldJumps.h"
#include "dggRootFinding.h"

#include <cmath>

namespace dgg
{
namespace
{
/// Maximum recursion depth of the search for wavefronts between two other wavefronts.
constexpr int MostDepth = 12;
/// Bisection steps for the point where two wavefronts tie.
constexpr int StepsOfTie = 40;
/// Bisection steps of the search for a ridge between samples without images.
constexpr int StepsOfCrest = 16;
/// Relative distance from an end below which points coincide with the end.
constexpr double AtEnd = 1e-7;

/// Points on a line at which the field may have an extremum.
class Line
{
public:
  Line(const LevelArc& arc, double level, const LevelPoint& from, const LevelPoint& to)
    : Arc(arc)
    , Level(level)
    , From(from.Place)
    , Way(Difference(to.Place, from.Place))
    , Length(Norm(this->Way.X, this->Way.Y))
  {
    this->Collect(0.0, from.Sample, 1.0, to.Sample, 0);
  }

  const std::vector<LevelPoint>& GetPoints() const { return this->Points; }

private:
  Point2 At(double t) const
  {
    return { this->From.X + t * this->Way.X, this->From.Y + t * this->Way.Y };
  }

  void Add(double t)
  {
    if (t > AtEnd && t < 1.0 - AtEnd)
    {
      this->Points.push_back(this->Arc.Evaluate(this->At(t)));
    }
  }

  /// Adds the minimum of a wavefront, if it lies between two positions.
  void AddFoot(const FieldSample& wave, double begin, double end)
  {
    const double t = Dot(Difference(wave.Image, this->From), this->Way) / Dot(this->Way, this->Way);
    if (t > begin && t < end)
    {
      this->Add(t);
    }
  }

  /// Collects ties and minima between two positions in order, given the nearest sources at these
  /// positions. Skips intervals that cannot reach the level, because slopes are at most 1.
  void Collect(
    double begin, const FieldSample& first, double end, const FieldSample& last, int depth)
  {
    if (std::abs(first.Distance + last.Distance - 2.0 * this->Level) > (end - begin) * this->Length)
    {
      return;
    }
    if (first.Candidate == last.Candidate)
    {
      this->AddFoot(first, begin, end);
      return;
    }
    const double tie = Bisect(begin, end, 0.0, StepsOfTie, [&](double t) {
      const Point2 p = this->At(t);
      return DistanceFromSource(first, p) < DistanceFromSource(last, p);
    });
    const FieldSample sample = this->Arc.Evaluate(this->At(tie)).Sample;
    const bool isOther = sample.HasImage && sample.Candidate != first.Candidate &&
      sample.Candidate != last.Candidate && depth < MostDepth;
    if (isOther)
    {
      this->Collect(begin, first, tie, sample, depth + 1);
      this->Add(tie);
      this->Collect(tie, sample, end, last, depth + 1);
      return;
    }
    this->AddFoot(first, begin, tie);
    this->Add(tie);
    this->AddFoot(last, tie, end);
  }

  const LevelArc& Arc;
  double Level;
  Point2 From;
  Point2 Way;
  double Length;
  std::vector<LevelPoint> Points;
};

/// Appends a point above the level between two points below the level, if the distance rises from
/// both. The gradient may be undefined at a corner of the face.
void FindCrest(const LevelArc& arc, double level, const LevelPoint& from, const LevelPoint& to,
  std::vector<LevelPoint>& turns)
{
  Point2 begin = from.Place;
  Point2 end = to.Place;
  const Point2 way = Difference(end, begin);
  if (!(Dot(from.Sample.Gradient, way) >= 0.0 && Dot(to.Sample.Gradient, way) <= 0.0 &&
        0.5 * (from.Sample.Distance + to.Sample.Distance + Norm(way.X, way.Y)) > level))
  {
    return;
  }
  for (int step = 0; step < StepsOfCrest; ++step)
  {
    const Point2 middle{ 0.5 * (begin.X + end.X), 0.5 * (begin.Y + end.Y) };
    const LevelPoint point = arc.Evaluate(middle);
    if (point.Sample.Distance >= level)
    {
      turns.push_back(point);
      return;
    }
    (Dot(point.Sample.Gradient, way) > 0.0 ? begin : end) = middle;
  }
}
}

void FindTurns(const LevelArc& arc, double level, const LevelEnd& from, const LevelEnd& to,
  std::vector<LevelPoint>& turns)
{
  if (!(Distance(from.Point.Place, to.Point.Place) > 0.0))
  {
    return;
  }
  if (!from.Point.Sample.HasImage || !to.Point.Sample.HasImage)
  {
    if (!from.IsAbove && !to.IsAbove)
    {
      FindCrest(arc, level, from.Point, to.Point, turns);
    }
    return;
  }
  const Line line(arc, level, from.Point, to.Point);
  const LevelPoint* best =
    nullptr; // farthest from the level, of consecutive points on one side of the level
  bool isAbove = from.IsAbove;
  const auto finish = [&] {
    if (best)
    {
      turns.push_back(*best);
    }
  };
  bool isFirst = true; // these belong to the first end
  for (const LevelPoint& point : line.GetPoints())
  {
    const bool isPointAbove = point.Sample.Distance >= level;
    if (isPointAbove != isAbove)
    {
      finish();
      best = nullptr;
      isAbove = isPointAbove;
      isFirst = false;
    }
    if (!isFirst && (!best || (point.Sample.Distance > best->Sample.Distance) == isAbove))
    {
      best = &point;
    }
  }
  if (isAbove != to.IsAbove)
  {
    finish();
  }
}
}
