// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFieldJumps.h"

#include <cmath>

namespace dgg
{
namespace
{
/// Relative tolerance between images of one source.
constexpr double ImageTolerance = 1e-8;
/// Minimum divergence of gradients that indicates a source between them.
constexpr double ApartTolerance = 0.05;
/// Largest width of slits, relative to the segment.
constexpr double SlitWidth = 1e-5;
constexpr int NewtonSteps = 12;
/// Relative step below which steps are rounding errors.
constexpr double LastStep = 1e-15;

Point2 DirectionFromSource(const FieldSample& sample, const Point2& p)
{
  const Point2 way = Difference(p, sample.Image);
  const double length = Norm(way.X, way.Y);
  return length > 0.0 ? Point2{ way.X / length, way.Y / length } : Point2{};
}
}

double AngleBetween(const FieldSample& a, const FieldSample& b)
{
  return std::abs(std::atan2(Cross(a.Gradient, b.Gradient), Dot(a.Gradient, b.Gradient)));
}

bool HaveOneSource(const FieldSample& a, const FieldSample& b, double length)
{
  if (!a.HasImage || !b.HasImage || a.Source != b.Source)
  {
    return false;
  }
  const double close =
    ImageTolerance * (length + std::abs(a.Distance - a.Offset) + std::abs(b.Distance - b.Offset));
  return std::abs(a.Offset - b.Offset) <= close && Distance(a.Image, b.Image) <= close;
}

double DistanceFromSource(const FieldSample& sample, const Point2& p)
{
  return sample.Offset + Distance(sample.Image, p);
}

bool MoveToTie(
  const FieldSample& a, const FieldSample& b, const Point2& direction, double limit, Point2& p)
{
  if (!a.HasImage || !b.HasImage)
  {
    return false;
  }
  const Point2 start = p;
  double moved = 0.0;
  for (int step = 0; step < NewtonSteps; ++step)
  {
    const Point2 here{ start.X + moved * direction.X, start.Y + moved * direction.Y };
    const double slope =
      Dot(Difference(DirectionFromSource(a, here), DirectionFromSource(b, here)), direction);
    const double difference = DistanceFromSource(a, here) - DistanceFromSource(b, here);
    if (difference == 0.0)
    {
      break;
    }
    const double change = -difference / slope;
    if (!(std::abs(moved + change) <= limit))
    {
      return false;
    }
    moved += change;
    if (std::abs(change) <= LastStep * (std::abs(moved) + limit))
    {
      break;
    }
  }
  p = { start.X + moved * direction.X, start.Y + moved * direction.Y };
  return true;
}

bool MoveToTie(const FieldSample& a, const FieldSample& b, const FieldSample& c, Point2& p)
{
  if (!a.HasImage || !b.HasImage || !c.HasImage)
  {
    return false;
  }
  Point2 here = p;
  for (int step = 0; step < NewtonSteps; ++step)
  {
    const Point2 direction = DirectionFromSource(a, here);
    const Point2 u = Difference(direction, DirectionFromSource(b, here));
    const Point2 v = Difference(direction, DirectionFromSource(c, here));
    const double f = DistanceFromSource(a, here) - DistanceFromSource(b, here);
    const double g = DistanceFromSource(a, here) - DistanceFromSource(c, here);
    const double determinant = Cross(u, v);
    const Point2 change{ (g * u.Y - f * v.Y) / determinant, (f * v.X - g * u.X) / determinant };
    if (!std::isfinite(change.X) || !std::isfinite(change.Y))
    {
      return false;
    }
    here = { here.X + change.X, here.Y + change.Y };
  }
  p = here;
  return true;
}

void FieldJumpFinder::Find(
  const Point2& p, const Point2& q, int count, double width, std::vector<FieldJump>& jumps) const
{
  std::vector<double> places;
  for (int i = 1; i < count; ++i)
  {
    places.push_back(static_cast<double>(i) / count);
  }
  this->Find(p, q, places, width, jumps);
}

void FieldJumpFinder::Find(const Point2& p, const Point2& q, const std::vector<double>& places,
  double width, std::vector<FieldJump>& jumps) const
{
  const Way way{ p, q, Distance(p, q), width, &jumps };
  const std::size_t first = jumps.size();
  double begin = 0.0;
  FieldSample atBegin = this->Envelope.SampleAt(p);
  for (std::size_t i = 0; i <= places.size(); ++i)
  {
    const double end = i < places.size() ? places[i] : 1.0;
    const FieldSample atEnd = this->Envelope.SampleAt(way.At(end));
    this->Search(way, begin, atBegin, end, atEnd);
    begin = end;
    atBegin = atEnd;
  }
  if (this->BetweenSources)
  {
    this->RemoveSlits(way, first);
  }
}

/// Removes pairs of jumps, from a given one on, that are close to each other and lead back to the
/// same source.
void FieldJumpFinder::RemoveSlits(const Way& way, std::size_t first) const
{
  std::vector<FieldJump>& jumps = *way.Jumps;
  for (std::size_t i = first; i + 1 < jumps.size();)
  {
    const auto pair = jumps.begin() + static_cast<std::ptrdiff_t>(i);
    if (pair[0].Before.Source == pair[1].After.Source &&
      Distance(pair[0].Place, pair[1].Place) <= SlitWidth * way.Length)
    {
      jumps.erase(pair, pair + 2);
      i = i > first ? i - 1 : i;
    }
    else
    {
      ++i;
    }
  }
}

/// Returns true if there may be a jump between two points at the given distance. Intervals with at
/// least half the angle are searched, because the gradient may turn back before and after a jump.
/// On overflow the angle is undefined, and the search is useless.
bool FieldJumpFinder::MayJump(const FieldSample& a, const FieldSample& b, double length) const
{
  return (this->BetweenSources || AngleBetween(a, b) >= 0.5 * this->Angle) &&
    !HaveOneSource(a, b, length);
}

/// Returns true if there is a jump between two samples that are close to each other.
bool FieldJumpFinder::IsJump(
  const Way& way, const FieldSample& before, const FieldSample& after) const
{
  if (this->BetweenSources)
  {
    return before.Source != after.Source;
  }
  const Point2 change = Difference(after.Gradient, before.Gradient);
  const double apart = Dot(change, Difference(way.To, way.From)) / way.Length;
  return AngleBetween(before, after) >= this->Angle &&
    apart <= ApartTolerance * Norm(change.X, change.Y);
}

/// Searches for jumps in an interval.
void FieldJumpFinder::Search(const Way& way, double begin, const FieldSample& atBegin, double end,
  const FieldSample& atEnd) const
{
  if (!this->MayJump(atBegin, atEnd, way.Length) ||
    this->SearchTie(way, begin, atBegin, end, atEnd))
  {
    return;
  }
  const double middle = 0.5 * (begin + end);
  if (end - begin > way.Width)
  {
    if (this->IsExhausted())
    {
      return;
    }
    --this->SamplesLeft;
    const FieldSample atMiddle = this->Envelope.SampleAt(way.At(middle));
    this->Search(way, begin, atBegin, middle, atMiddle);
    this->Search(way, middle, atMiddle, end, atEnd);
    return;
  }
  this->Add(way, middle, atBegin, atEnd);
}

/// Handles the usual case of two sources, with the jump at their tie. Returns false in other cases.
bool FieldJumpFinder::SearchTie(const Way& way, double begin, const FieldSample& atBegin,
  double end, const FieldSample& atEnd) const
{
  const Point2 axis{ (way.To.X - way.From.X) / way.Length, (way.To.Y - way.From.Y) / way.Length };
  const double middle = 0.5 * (begin + end);
  Point2 tie = way.At(middle);
  if (!MoveToTie(atBegin, atEnd, axis, 0.5 * (end - begin) * way.Length, tie))
  {
    return false;
  }
  const double t = middle + Dot(axis, Difference(tie, way.At(middle))) / way.Length;
  const double before = t - 0.5 * way.Width;
  const double after = t + 0.5 * way.Width;
  if (!(before >= begin && after <= end))
  {
    return false;
  }
  const FieldSample atBefore = this->Envelope.SampleAt(way.At(before));
  const FieldSample atAfter = this->Envelope.SampleAt(way.At(after));
  if (!HaveOneSource(atBegin, atBefore, way.Length) || !HaveOneSource(atEnd, atAfter, way.Length))
  {
    return false;
  }
  this->Add(way, t, atBefore, atAfter);
  return true;
}

void FieldJumpFinder::Add(
  const Way& way, double t, const FieldSample& before, const FieldSample& after) const
{
  if (this->IsJump(way, before, after))
  {
    way.Jumps->push_back({ way.At(t), before, after });
  }
}
}
