// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLevelArc.h"

#include "dggRootFinding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Relative rounding error of distances.
constexpr double Rounding = 4e-13;
/// Distance below which points coincide, relative to the face.
constexpr double SamePoint = 1e-10;
/// Relative distance below which images may coincide.
constexpr double SameImage = 1e-9;
/// Tolerance of points outside the face, in barycentric coordinates.
constexpr double Outside = 1e-13;
/// Maximum number of bisections of a chord.
constexpr int DeepestChord = 12;
constexpr int MostNewtonSteps = 10;
/// Maximum distance of Newton steps from the middle of a chord, in chord lengths. With this limit
/// the steps do not reach the ends of the chord.
constexpr double NewtonReach = 0.8;
/// Initial search distance from a chord to its isoline, in chord lengths.
constexpr double NearestSearch = 1.0 / 16.0;
constexpr int StepsOfSearch = 15; // the distance doubles in each step
constexpr int MostRootSteps = 80;
/// Maximum number of pieces, each below the previous one, in the search for a corner.
constexpr int MostPieces = 8;
/// Maximum turning angle between two points of an arc, and of an arc within a face, radians.
constexpr double LargestStep = Pi / 6.0;
constexpr double LargestTurn = 1.4 * Pi;
/// Turning angle below which corners are not visible, radians.
constexpr double SmallTurn = 0.05;
/// Sine of half the angle of the sharpest corners.
constexpr double SharpestWedge = 1e-3;
/// Length below which pieces have no corners, as a fraction of the tolerance.
constexpr double SmallPart = 0.01;
constexpr double MostPointsOfArc = 4096.0;

Point2 Between(const Point2& a, const Point2& b, double t)
{
  return { a.X + t * (b.X - a.X), a.Y + t * (b.Y - a.Y) };
}
}

LevelArc::LevelArc(const FaceEnvelope& envelope, double level, double tolerance)
  : Envelope(envelope)
  , Level(level)
  , Tolerance(tolerance)
{
  const std::array<Point2, 3>& corners = envelope.GetCorners();
  this->Size = std::max({ Distance(corners[0], corners[1]), Distance(corners[1], corners[2]),
    Distance(corners[2], corners[0]) });
  this->Close = Rounding * (std::abs(level) + this->Size);
}

LevelPoint LevelArc::Evaluate(const Point2& place) const
{
  LevelPoint point{ place, this->Envelope.SampleAt(place), false };
  point.IsOnLevel = std::abs(point.Sample.Distance - this->Level) <= this->Close;
  return point;
}

bool LevelArc::IsInside(const Point2& place) const
{
  const std::array<double, 3> b = this->Envelope.BarycentricOf(place);
  return std::min({ b[0], b[1], b[2] }) >= -Outside;
}

LevelPoint LevelArc::FindBetween(const LevelPoint& below, const LevelPoint& above) const
{
  struct Probe
  {
    double X; // 0 at the point below, 1 at the point above
    double Height;
    LevelPoint Point;
  };
  const Probe begin{ 0.0, below.Sample.Distance - this->Level, below };
  const Probe end{ 1.0, above.Sample.Distance - this->Level, above };
  if (!(begin.Height < 0.0 && end.Height >= 0.0))
  {
    LevelPoint closest = std::abs(begin.Height) < std::abs(end.Height) ? below : above;
    closest.IsOnLevel = false;
    return closest;
  }
  const auto look = [&](double t) {
    const LevelPoint point = this->Evaluate(Between(below.Place, above.Place, t));
    return Probe{ t, point.Sample.Distance - this->Level, point };
  };
  return FindRoot(begin, end, 1e-3 * this->Close, MostRootSteps, look).Point;
}

/// Returns true if both points belong to the same smooth piece of the field.
bool LevelArc::IsSamePiece(const LevelPoint& a, const LevelPoint& b) const
{
  if (!a.Sample.HasImage || !b.Sample.HasImage)
  {
    return a.Sample.Candidate == b.Sample.Candidate;
  }
  const double close = SameImage * (this->Size + std::abs(this->Level - a.Sample.Offset));
  return Distance(a.Sample.Image, b.Sample.Image) <= close &&
    std::abs(a.Sample.Offset - b.Sample.Offset) <= close;
}

/// Returns true if the isoline may have a corner between two points that is visible, or higher than
/// the tolerance. Gradients turn as much as the isoline does.
bool LevelArc::MayTurn(const LevelPoint& a, const LevelPoint& b) const
{
  const double turn = Distance(a.Sample.Gradient, b.Sample.Gradient);
  const double length = Distance(a.Place, b.Place);
  return (turn > SmallTurn && length > SmallPart * this->Tolerance) ||
    length * turn > 4.0 * this->Tolerance;
}

bool LevelArc::RefineChord(
  const LevelPoint& from, const LevelPoint& to, int depth, std::vector<Point2>& points) const
{
  if (Distance(from.Place, to.Place) <= SamePoint * this->Size)
  {
    return true;
  }
  if (from.IsOnLevel && to.IsOnLevel)
  {
    LevelPoint before;
    LevelPoint after;
    if (this->IsSamePiece(from, to))
    {
      if (from.Sample.HasImage && this->AddArc(from, to, points))
      {
        return true;
      }
    }
    else if (depth < DeepestChord && this->MayTurn(from, to) &&
      this->FindCorner(from, to, before, after))
    {
      const bool isFirst = this->RefineChord(from, before, depth + 1, points);
      if (Distance(from.Place, before.Place) > SamePoint * this->Size &&
        Distance(to.Place, before.Place) > SamePoint * this->Size)
      {
        points.push_back(before.Place);
      }
      return this->RefineChord(after, to, depth + 1, points) && isFirst;
    }
  }
  const LevelPoint middle = this->Project(from, to);
  if (!middle.IsOnLevel)
  {
    return false;
  }
  const Point2 chord = Difference(to.Place, from.Place);
  const double length = Norm(chord.X, chord.Y);
  const double height = std::abs(Cross(chord, Difference(middle.Place, from.Place))) / length;
  // The isoline may have a corner between the ends that the middle does not reveal.
  if (height <= this->Tolerance && (this->IsSamePiece(from, to) || !this->MayTurn(from, to)))
  {
    return true;
  }
  if (depth >= DeepestChord)
  {
    return false;
  }
  const bool isFirst = this->RefineChord(from, middle, depth + 1, points);
  points.push_back(middle.Place);
  return this->RefineChord(middle, to, depth + 1, points) && isFirst;
}

/// Adds evenly spaced points of a circle, if both ends have the same source. Returns false without
/// adding points if a point of the circle is not at the level because another source is nearer.
bool LevelArc::AddArc(
  const LevelPoint& from, const LevelPoint& to, std::vector<Point2>& points) const
{
  const Point2& image = from.Sample.Image;
  const double radius = this->Level - from.Sample.Offset;
  const Point2 first = Difference(from.Place, image);
  const Point2 last = Difference(to.Place, image);
  const double begin = std::atan2(first.Y, first.X);
  double turn = std::atan2(Cross(first, last), Dot(first, last));
  if (turn < 0.0)
  {
    turn = -turn * radius <= SamePoint * this->Size ? 0.0 : turn + 2.0 * Pi;
  }
  if (!(radius > 0.0) || turn > LargestTurn)
  {
    return false;
  }
  // The distance of an arc of angle a from its chord is at most (1 - cos(a / 2)) radius.
  const double sine = std::sqrt(std::min(0.5, 0.5 * this->Tolerance / radius));
  const double step = std::min(LargestStep, 4.0 * std::asin(sine));
  const double count = std::max(1.0, std::min(MostPointsOfArc, std::ceil(turn / step)));
  const std::size_t size = points.size();
  auto place = [&](double t) {
    const double angle = begin + t * turn;
    return Point2{ image.X + radius * std::cos(angle), image.Y + radius * std::sin(angle) };
  };
  // Between two points another source may be nearer.
  bool isThere = this->Evaluate(place(0.5 / count)).IsOnLevel;
  for (double i = 1.0; i < count && isThere; i += 1.0)
  {
    const Point2 p = place(i / count);
    isThere = this->IsInside(p) && this->Evaluate(p).IsOnLevel &&
      this->Evaluate(place((i + 0.5) / count)).IsOnLevel;
    points.push_back(p);
  }
  if (!isThere)
  {
    points.resize(size);
  }
  return isThere;
}

/// Finds the corner between two pieces of the isoline. Returns false if no corner is found. If the
/// field at the intersection of both pieces comes from a third piece, which may be too short to be
/// found otherwise, the corner with the third piece is found instead.
bool LevelArc::FindCorner(
  const LevelPoint& from, const LevelPoint& to, LevelPoint& before, LevelPoint& after) const
{
  before = from;
  after = to;
  Point2 place;
  LevelPoint found;
  for (int step = 0; step < MostPieces && !found.IsOnLevel; ++step)
  {
    if (!this->MeetCandidates(from, after, place))
    {
      return false;
    }
    found = this->Evaluate(place);
    if (!found.IsOnLevel)
    {
      if (found.Sample.Distance > this->Level)
      {
        return false;
      }
      after.Sample = found.Sample;
    }
  }
  // The corner of a wedge of half-angle beta is 1 / (2 sin(beta)) lengths of the chord away.
  const double turn = 0.5 * Distance(from.Sample.Gradient, to.Sample.Gradient);
  const double sine = std::sqrt(std::max(0.0, 1.0 - turn * turn));
  const double reach =
    2.0 * Distance(from.Place, to.Place) * (1.0 + 1.0 / std::max(sine, SharpestWedge));
  if (!found.IsOnLevel || !(Distance(place, from.Place) <= reach) ||
    !(Distance(place, to.Place) <= reach) || !this->IsInside(place))
  {
    return false;
  }
  // Nearly coinciding circles intersect at arbitrary points; a line must not run backward along
  // either circle.
  const auto runsBack = [&](const FieldSample& sample, const Point2& p, const Point2& q) {
    return sample.HasImage &&
      Cross(Difference(p, sample.Image), Difference(q, sample.Image)) <
      -SamePoint * this->Size * (this->Level - sample.Offset);
  };
  if (runsBack(before.Sample, from.Place, place) || runsBack(after.Sample, place, to.Place))
  {
    return false;
  }
  before.Place = after.Place = place;
  before.IsOnLevel = after.IsOnLevel = true;
  return true;
}

/// Finds the intersection of the level sets of both pieces, by Newton's method starting at the
/// middle of the chord. Returns false if the method fails.
bool LevelArc::MeetCandidates(const LevelPoint& from, const LevelPoint& to, Point2& corner) const
{
  const Point2 middle = Between(from.Place, to.Place, 0.5);
  corner = middle;
  for (int step = 0; step < MostNewtonSteps; ++step)
  {
    const FieldSample a = this->Envelope.SampleOfCandidate(from.Sample, corner);
    const FieldSample b = this->Envelope.SampleOfCandidate(to.Sample, corner);
    const double missA = this->Level - a.Distance;
    const double missB = this->Level - b.Distance;
    if (std::max(std::abs(missA), std::abs(missB)) <= 1e-3 * this->Close)
    {
      break;
    }
    const double area = Cross(a.Gradient, b.Gradient);
    corner.X += (missA * b.Gradient.Y - missB * a.Gradient.Y) / area;
    corner.Y += (missB * a.Gradient.X - missA * b.Gradient.X) / area;
    if (!(Distance(corner, middle) <= this->Size))
    {
      return false; // nearly tangent
    }
  }
  return true;
}

/// Returns a point at the level beside the middle of a chord.
LevelPoint LevelArc::Project(const LevelPoint& from, const LevelPoint& to) const
{
  const double reach = NewtonReach * Distance(from.Place, to.Place);
  const LevelPoint start = this->Evaluate(Between(from.Place, to.Place, 0.5));
  LevelPoint point = start;
  LevelPoint best = start;
  for (int step = 0; step < MostNewtonSteps; ++step)
  {
    const double miss = point.Sample.Distance - this->Level;
    if (std::abs(miss) <= 1e-3 * this->Close)
    {
      return point;
    }
    if (step > 0 && point.IsOnLevel && point.Sample.HasImage)
    {
      return point;
    }
    const Point2& slope = point.Sample.Gradient;
    const double square = Dot(slope, slope);
    const Point2 place{ point.Place.X - miss * slope.X / square,
      point.Place.Y - miss * slope.Y / square };
    if (!(square > 1e-6) || !(Distance(place, start.Place) <= reach) || !this->IsInside(place))
    {
      break;
    }
    point = this->Evaluate(place);
    best = point.IsOnLevel ? point : best;
  }
  if (best.IsOnLevel)
  {
    return best;
  }
  // The search goes to the right if the start is below the level, since lower distances are on the
  // left.
  const bool isBelow = start.Sample.Distance < this->Level;
  const double side = isBelow ? -1.0 : 1.0;
  const Point2 way = Difference(to.Place, from.Place);
  for (int step = 0; step < StepsOfSearch; ++step)
  {
    const double t = std::ldexp(NearestSearch, step);
    const Point2 place{ start.Place.X - side * t * way.Y, start.Place.Y + side * t * way.X };
    if (!this->IsInside(place))
    {
      break;
    }
    const LevelPoint other = this->Evaluate(place);
    if ((other.Sample.Distance < this->Level) != isBelow)
    {
      return this->FindBetween(isBelow ? start : other, isBelow ? other : start);
    }
  }
  best.IsOnLevel = false;
  return best;
}
}
