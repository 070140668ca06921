// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphWindowMemory.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Relative tolerance within which distances are equal.
constexpr double Tolerance = 1e-12;
/// Relative width below which gaps between intervals are ignored as rounding errors.
constexpr double GapTolerance = 1e-9;
/// Maximum number of steps of the search for a tie.
constexpr int TieSteps = 10;
}

Id GraphWindowMemory::Admit(
  const Passage& passage, const Relay& left, const Relay& right, const GraphWindow& window)
{
  const bool isReversed = passage.IsReversed;
  Point2 rays[2] = { left.Position, right.Position };
  if (window.Number != NoId)
  {
    const Entry& parent = this->Entries[window.Number];
    const Point2& liveLeft = parent.IsReversed ? parent.AtEnd : parent.AtBegin;
    const Point2& liveRight = parent.IsReversed ? parent.AtBegin : parent.AtEnd;
    rays[0] = Cross(liveLeft, rays[0]) > 0.0 ? liveLeft : rays[0];
    rays[1] = Cross(rays[1], liveRight) > 0.0 ? liveRight : rays[1];
  }
  if (!(Cross(rays[1], rays[0]) > 0.0))
  {
    return NoId; // the live part is on the other side of the apex
  }
  const double length = Distance(window.Ends[0], window.Ends[1]);
  const auto imageOf = [&](const Point2& p) {
    const Point2 way{ p.X - window.Ends[0].X, p.Y - window.Ends[0].Y };
    const double x = Dot(way, window.Axis);
    return Image{ isReversed ? length - x : x, std::abs(Cross(way, window.Axis)) };
  };
  Entry entry;
  entry.HalfEdge = passage.HalfEdge;
  entry.Before = this->Last[passage.HalfEdge];
  entry.IsReversed = isReversed;
  entry.AtBegin = MeetEdge(window, rays[isReversed ? 1 : 0]);
  entry.AtEnd = MeetEdge(window, rays[isReversed ? 0 : 1]);
  entry.Begin = imageOf(entry.AtBegin).Foot;
  entry.End = imageOf(entry.AtEnd).Foot;
  entry.Source = imageOf({ 0.0, 0.0 });
  entry.Corners = { passage.Origin, passage.Destination, passage.Behind };
  entry.CornersAt = { { { 0.0, 0.0 }, { length, 0.0 }, imageOf(passage.BehindAt) } };
  if (!this->Trim(entry, NoId))
  {
    return NoId;
  }
  this->Last[entry.HalfEdge] = static_cast<Id>(this->Entries.size());
  this->Entries.push_back(entry);
  return this->Last[entry.HalfEdge];
}

/// Trims dominated parts at both ends of an entry. Returns false if no part is left. A new entry
/// (`number` is NoId) is also dominated by equal entries.
bool GraphWindowMemory::Trim(Entry& entry, Id number)
{
  this->FindDominated(entry, number);
  const double slack = GapTolerance * (entry.Source.Depth + entry.End - entry.Begin);
  double begin = entry.Begin;
  double end = entry.End;
  std::sort(this->Dominated.begin(), this->Dominated.end(),
    [](const Interval& a, const Interval& b) { return a.Begin < b.Begin; });
  for (const Interval& interval : this->Dominated)
  {
    begin = interval.Begin <= begin + slack ? std::max(begin, interval.End) : begin;
  }
  std::sort(this->Dominated.begin(), this->Dominated.end(),
    [](const Interval& a, const Interval& b) { return a.End > b.End; });
  for (const Interval& interval : this->Dominated)
  {
    end = interval.End >= end - slack ? std::min(end, interval.Begin) : end;
  }
  const Point2 way{ entry.AtEnd.X - entry.AtBegin.X, entry.AtEnd.Y - entry.AtBegin.Y };
  const auto place = [&](double x) {
    const double t = (x - entry.Begin) / (entry.End - entry.Begin);
    return Point2{ entry.AtBegin.X + t * way.X, entry.AtBegin.Y + t * way.Y };
  };
  const Point2 first = begin > entry.Begin ? place(begin) : entry.AtBegin;
  entry.AtEnd = end < entry.End ? place(end) : entry.AtEnd;
  entry.AtBegin = first;
  entry.Begin = begin;
  entry.End = end;
  return end - begin > slack;
}

/// Finds the intervals of an entry where other paths are at least as short.
void GraphWindowMemory::FindDominated(const Entry& entry, Id number)
{
  this->Dominated.clear();
  const double longest =
    std::max(entry.Source.DistanceAt(entry.Begin), entry.Source.DistanceAt(entry.End));
  for (int k = 0; k < 3; ++k)
  {
    const double label =
      entry.Corners[k] == NoId ? Infinity : (*this->Vertices)[entry.Corners[k]].Label;
    if (label > 0.0 && label < longest) // the source itself is not an alternative
    {
      this->Compare(entry, { entry.CornersAt[k], label }, entry.Begin, entry.End, 1.0 - Tolerance);
    }
  }
  const double factor = number == NoId ? 1.0 + Tolerance : 1.0 - Tolerance;
  for (Id i = this->Last[entry.HalfEdge]; i != NoId; i = this->Entries[i].Before)
  {
    const Entry& other = this->Entries[i];
    const double begin = std::max(entry.Begin, other.Begin);
    const double end = std::min(entry.End, other.End);
    ++this->Work;
    if (i != number && begin < end)
    {
      this->Compare(entry, { other.Source, 0.0 }, begin, end, factor);
    }
  }
}

/// Finds the interval where another path is shorter. The points that are nearer to one focus than
/// to another by a given difference form a convex region bounded by a branch of a hyperbola;
/// therefore the interval is unique. Dominated intervals between two points that are not dominated
/// are ignored.
void GraphWindowMemory::Compare(
  const Entry& entry, const Way& other, double begin, double end, double factor)
{
  const auto excessAt = [&](double x) {
    return other.Label + other.From.DistanceAt(x) - factor * entry.Source.DistanceAt(x);
  };
  double atBegin = excessAt(begin);
  double atEnd = excessAt(end);
  if (atBegin > 0.0 && atEnd > 0.0)
  {
    return;
  }
  const bool fromBegin = atBegin <= 0.0;
  double inside = fromBegin ? end : begin;
  if (atBegin > 0.0 || atEnd > 0.0)
  {
    // Regula falsi, Illinois variant.
    inside = fromBegin ? begin : end;
    double outside = fromBegin ? end : begin;
    double atInside = fromBegin ? atBegin : atEnd;
    double atOutside = fromBegin ? atEnd : atBegin;
    for (int step = 0; step < TieSteps && atInside < 0.0; ++step)
    {
      const double x = inside + (outside - inside) * (atInside / (atInside - atOutside));
      const double excess = excessAt(x);
      const bool isInside = excess <= 0.0;
      (isInside ? inside : outside) = x;
      (isInside ? atInside : atOutside) = excess;
      (isInside ? atOutside : atInside) *= 0.5;
    }
  }
  this->Dominated.push_back(fromBegin ? Interval{ begin, inside } : Interval{ inside, end });
}

void GraphWindowMemory::Clear()
{
  for (const Entry& entry : this->Entries)
  {
    this->Last[entry.HalfEdge] = NoId;
  }
  this->Entries.clear();
  this->Work = 0;
}
}
