// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceSplitter.h"

#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <tuple>
#include <utility>

namespace dgg
{
namespace
{
/// Segments between two reports.
constexpr std::size_t ProgressInterval = 256;
/// Rounds of splitting segments in one face before giving up. Two do, but for rounding.
constexpr int MaximumRounds = 100;

/// Whether a point is close to a segment, between its ends.
bool IsBetween(const GridPoint& p, const GridPoint& a, const GridPoint& b)
{
  auto real = [](std::int64_t x) { return static_cast<double>(x); };
  const double ux = real(b.X - a.X);
  const double uy = real(b.Y - a.Y);
  const double vx = real(p.X - a.X);
  const double vy = real(p.Y - a.Y);
  const double square = ux * ux + uy * uy;
  const double along = ux * vx + uy * vy;
  return along > 0.0 && along < square &&
    std::abs(ux * vy - uy * vx) <= real(PathNodes::MergeDistance) * std::sqrt(square);
}

/// How far along a segment a point is, in grid units squared.
double Along(const GridPoint& p, const GridPoint& a, const GridPoint& b)
{
  auto real = [](std::int64_t x) { return static_cast<double>(x); };
  return real(b.X - a.X) * real(p.X - a.X) + real(b.Y - a.Y) * real(p.Y - a.Y);
}

GridPoint Intersection(
  const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d)
{
  auto real = [](std::int64_t x) { return static_cast<long double>(x); };
  const long double ux = real(b.X - a.X);
  const long double uy = real(b.Y - a.Y);
  const long double vx = real(d.X - c.X);
  const long double vy = real(d.Y - c.Y);
  const long double t = (real(c.X - a.X) * vy - real(c.Y - a.Y) * vx) / (ux * vy - uy * vx);
  GridPoint p{ a.X + std::llround(t * ux), a.Y + std::llround(t * uy) };
  // Not on a side: the next face knows nothing of it.
  p.X = std::max<std::int64_t>(1, std::min(p.X, GridPoint::One - 2));
  p.Y = std::max<std::int64_t>(1, std::min(p.Y, GridPoint::One - 1 - p.X));
  return p;
}
}

Status PieceSplitter::Split(
  Id face, const std::vector<std::size_t>& places, const ProgressCallback& progress)
{
  double begin = 0.0;
  for (int round = 0; round < MaximumRounds; ++round)
  {
    // Each round gets half of what is left, and so does each turn of its first half.
    const double share = 0.25 * (1.0 - begin);
    const double middle = begin + share;
    bool found = true;
    while (found)
    {
      for (const std::size_t p : places)
      {
        this->SplitAlongSides(this->Pieces[p], face);
      }
      this->CollectSegments(face, places);
      const double end = 0.5 * (begin + middle);
      if (!this->SplitAtNodes(face, ProgressPart(progress, begin, end), found))
      {
        return Status::Abort();
      }
      begin = end;
    }
    Status status =
      this->SplitAtCrossings(face, ProgressPart(progress, middle, middle + share), found);
    if (!status.IsOk() || !found)
    {
      return status;
    }
    begin = middle + share;
  }
  std::ostringstream message;
  message << "the crossings of paths in face " << face << " are too close together";
  return Status::Invalid(message.str());
}

/// The node that follows a on the way to b along a side of the face.
Id PieceSplitter::FindNextOnSide(Id a, Id b, Id face, int side) const
{
  const int from = this->Nodes.PositionOnSide(a, face, side);
  const int to = this->Nodes.PositionOnSide(b, face, side);
  if (std::abs(from - to) <= 1)
  {
    return b;
  }
  return this->Nodes.NodeOnSide(face, side, from < to ? from + 1 : from - 1);
}

/// Make a piece run through all nodes that it passes on sides of the face.
void PieceSplitter::SplitAlongSides(PathPiece& piece, Id face) const
{
  std::vector<Id>& nodes = piece.Nodes;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
  {
    int side = 0;
    if (this->IsOnSide(nodes[i], nodes[i + 1], face, side))
    {
      const Id next = this->FindNextOnSide(nodes[i], nodes[i + 1], face, side);
      if (next != nodes[i + 1])
      {
        nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(i) + 1, next);
      }
    }
  }
}

bool PieceSplitter::IsOnSide(Id a, Id b, Id face, int& side) const
{
  return !this->Nodes.IsInside(a) && !this->Nodes.IsInside(b) &&
    this->Nodes.AreOnOneSide(a, b, face, side);
}

/// The segments of the pieces that are not on sides, where nothing crosses them.
void PieceSplitter::CollectSegments(Id face, const std::vector<std::size_t>& places)
{
  this->Segments.clear();
  this->Lines.clear();
  for (const std::size_t p : places)
  {
    const std::vector<Id>& nodes = this->Pieces[p].Nodes;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      int side = 0;
      if (!this->IsOnSide(nodes[i], nodes[i + 1], face, side))
      {
        this->Segments.push_back({ p, i });
        this->Lines.push_back(
          { this->Nodes.PlaceOf(nodes[i], face), this->Nodes.PlaceOf(nodes[i + 1], face) });
      }
    }
  }
  this->Tree.Build(this->Lines);
}

/// Make segments run through nodes that they pass, also those on sides: otherwise crossings would
/// come closer to these than nodes may be. Tells whether there were any; then the segments are to
/// be collected anew, as parts of them may pass others. False when stopped.
bool PieceSplitter::SplitAtNodes(Id face, const ProgressCallback& progress, bool& found)
{
  found = false;
  const std::vector<Id> candidates = this->Nodes.CollectNodes(face);
  std::vector<std::pair<std::size_t, Id>> passed; // segments, and nodes in their order
  std::vector<std::size_t> close;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (i % ProgressInterval == ProgressInterval - 1 && progress &&
      !progress(static_cast<double>(i) / static_cast<double>(candidates.size())))
    {
      return false;
    }
    const GridPoint place = this->Nodes.PlaceOf(candidates[i], face);
    this->Tree.Find(GridBox::Around(place, PathNodes::MergeDistance), close);
    for (const std::size_t s : close)
    {
      if (IsBetween(place, this->Lines[s].From, this->Lines[s].To))
      {
        passed.emplace_back(s, candidates[i]);
      }
    }
  }
  std::stable_sort(passed.begin(), passed.end(),
    [](const auto& first, const auto& second) { return first.first > second.first; });
  // From the back, so that places in the lists of nodes stay what they are.
  for (std::size_t begin = 0; begin < passed.size();)
  {
    std::size_t end = begin + 1;
    while (end < passed.size() && passed[end].first == passed[begin].first)
    {
      ++end;
    }
    const Segment& segment = this->Segments[passed[begin].first];
    std::vector<Id>& nodes = this->Pieces[segment.Piece].Nodes;
    std::size_t last = segment.Start + 1; // of the part of the list that was the segment
    for (std::size_t i = begin; i < end; ++i)
    {
      const Id node = passed[i].second;
      if (std::find(nodes.begin(), nodes.end(), node) != nodes.end())
      {
        continue;
      }
      const GridPoint place = this->Nodes.PlaceOf(node, face);
      for (std::size_t n = segment.Start; n < last; ++n)
      {
        if (IsBetween(
              place, this->Nodes.PlaceOf(nodes[n], face), this->Nodes.PlaceOf(nodes[n + 1], face)))
        {
          nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(n) + 1, node);
          ++last;
          found = true;
          break;
        }
      }
    }
    begin = end;
  }
  return true;
}

/// Look for pieces that cross, and insert nodes there, or fail.
Status PieceSplitter::SplitAtCrossings(Id face, const ProgressCallback& progress, bool& found)
{
  struct Insertion
  {
    std::size_t Piece;
    std::size_t Start;
    double Along;
    Id Node;
  };
  std::vector<Insertion> insertions;
  std::vector<std::size_t> close;
  for (std::size_t i = 0; i < this->Segments.size(); ++i)
  {
    if (i % ProgressInterval == ProgressInterval - 1 && progress &&
      !progress(static_cast<double>(i) / static_cast<double>(this->Segments.size())))
    {
      return Status::Abort();
    }
    const GridSegment& p = this->Lines[i];
    this->Tree.Find(GridBox::Around(p), close);
    for (auto j = std::upper_bound(close.begin(), close.end(), i); j != close.end(); ++j)
    {
      const GridSegment& q = this->Lines[*j];
      if (!CrossProperly(p.From, p.To, q.From, q.To))
      {
        continue;
      }
      if (!this->InsertCrossings)
      {
        std::ostringstream message;
        message << "paths " << this->Pieces[this->Segments[i].Piece].Path << " and "
                << this->Pieces[this->Segments[*j].Piece].Path << " cross in face " << face;
        return Status::Invalid(message.str());
      }
      const Id node = this->Nodes.AddCrossing(Intersection(p.From, p.To, q.From, q.To), face);
      for (const std::size_t s : { i, *j })
      {
        const Segment& segment = this->Segments[s];
        const std::vector<Id>& nodes = this->Pieces[segment.Piece].Nodes;
        if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
        {
          insertions.push_back({ segment.Piece, segment.Start,
            Along(this->Nodes.PlaceOf(node, face), this->Lines[s].From, this->Lines[s].To), node });
        }
      }
    }
  }
  // From the back, so that places in the lists of nodes stay what they are.
  std::sort(
    insertions.begin(), insertions.end(), [](const Insertion& first, const Insertion& second) {
      return std::tie(first.Piece, first.Start, first.Along, first.Node) >
        std::tie(second.Piece, second.Start, second.Along, second.Node);
    });
  for (const Insertion& insertion : insertions)
  {
    std::vector<Id>& nodes = this->Pieces[insertion.Piece].Nodes;
    if (std::find(nodes.begin(), nodes.end(), insertion.Node) == nodes.end())
    {
      nodes.insert(
        nodes.begin() + static_cast<std::ptrdiff_t>(insertion.Start) + 1, insertion.Node);
    }
  }
  found = !insertions.empty();
  return Status::Success();
}
}
