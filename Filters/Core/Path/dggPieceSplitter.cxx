// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceSplitter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <tuple>

namespace dgg
{
namespace
{
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

/// Whether the boxes around two segments meet.
bool MayMeet(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d)
{
  return std::max(a.X, b.X) >= std::min(c.X, d.X) && std::max(c.X, d.X) >= std::min(a.X, b.X) &&
    std::max(a.Y, b.Y) >= std::min(c.Y, d.Y) && std::max(c.Y, d.Y) >= std::min(a.Y, b.Y);
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

Status PieceSplitter::Split(Id face, const std::vector<std::size_t>& places)
{
  for (int round = 0; round < MaximumRounds; ++round)
  {
    for (const std::size_t p : places)
    {
      while (this->SplitAtNodes(this->Pieces[p], face))
      {
      }
    }
    bool found = false;
    Status status = this->SplitAtCrossings(face, places, found);
    if (!status.IsOk() || !found)
    {
      return status;
    }
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

/// Make a piece run through one more node that it passes. False when there is none.
bool PieceSplitter::SplitAtNodes(PathPiece& piece, Id face) const
{
  const std::vector<Id>* inside = this->Nodes.FindInFace(face);
  for (std::size_t i = 0; i + 1 < piece.Nodes.size(); ++i)
  {
    const Id a = piece.Nodes[i];
    const Id b = piece.Nodes[i + 1];
    int side = 0;
    if (!this->Nodes.IsInside(a) && !this->Nodes.IsInside(b) &&
      this->Nodes.AreOnOneSide(a, b, face, side))
    {
      const Id next = this->FindNextOnSide(a, b, face, side);
      if (next != b)
      {
        piece.Nodes.insert(piece.Nodes.begin() + static_cast<std::ptrdiff_t>(i) + 1, next);
        return true;
      }
      continue;
    }
    if (!inside)
    {
      continue;
    }
    const GridPoint pa = this->Nodes.PlaceOf(a, face);
    const GridPoint pb = this->Nodes.PlaceOf(b, face);
    for (const Id node : *inside)
    {
      if (std::find(piece.Nodes.begin(), piece.Nodes.end(), node) == piece.Nodes.end() &&
        IsBetween(this->Nodes.PlaceOf(node, face), pa, pb))
      {
        piece.Nodes.insert(piece.Nodes.begin() + static_cast<std::ptrdiff_t>(i) + 1, node);
        return true;
      }
    }
  }
  return false;
}

/// Look for pieces that cross, and insert nodes there, or fail.
Status PieceSplitter::SplitAtCrossings(Id face, const std::vector<std::size_t>& places, bool& found)
{
  struct Segment
  {
    std::size_t Piece;
    std::size_t Start; // among the nodes of the piece
    GridPoint From;
    GridPoint To;
  };
  std::vector<Segment> segments;
  for (const std::size_t p : places)
  {
    const std::vector<Id>& nodes = this->Pieces[p].Nodes;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      segments.push_back(
        { p, i, this->Nodes.PlaceOf(nodes[i], face), this->Nodes.PlaceOf(nodes[i + 1], face) });
    }
  }
  struct Insertion
  {
    std::size_t Piece;
    std::size_t Start;
    double Along;
    Id Node;
  };
  std::vector<Insertion> insertions;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (std::size_t j = i + 1; j < segments.size(); ++j)
    {
      const Segment& p = segments[i];
      const Segment& q = segments[j];
      if (!MayMeet(p.From, p.To, q.From, q.To) || !CrossProperly(p.From, p.To, q.From, q.To))
      {
        continue;
      }
      if (!this->InsertCrossings)
      {
        std::ostringstream message;
        message << "paths " << this->Pieces[p.Piece].Path << " and " << this->Pieces[q.Piece].Path
                << " cross in face " << face;
        return Status::Invalid(message.str());
      }
      const Id node = this->Nodes.AddCrossing(Intersection(p.From, p.To, q.From, q.To), face);
      for (const Segment& segment : { p, q })
      {
        const std::vector<Id>& nodes = this->Pieces[segment.Piece].Nodes;
        if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
        {
          insertions.push_back({ segment.Piece, segment.Start,
            Along(this->Nodes.PlaceOf(node, face), segment.From, segment.To), node });
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
