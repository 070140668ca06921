// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceSplitter.h"

#include "dggFaceTriangulation.h"
#include "dggProgressPart.h"
#include "dggStatus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

namespace dgg
{
namespace
{
/// Number of segments per leaf of the tree.
constexpr std::size_t LeafSize = 8;
/// Segments between two progress reports.
constexpr std::size_t ProgressInterval = 256;
/// Maximum number of rounds of splitting segments in one face. Two suffice except for rounding.
constexpr int MaximumRounds = 100;

struct GridSegment
{
  GridPoint From;
  GridPoint To;
};

/// A closed octagon on the grid: bounds of X, Y, X + Y and X - Y. Axis-aligned boxes around
/// adjacent slanted segments would overlap.
struct GridBox
{
  std::array<std::int64_t, 4> Low;
  std::array<std::int64_t, 4> High;

  /// Returns the box around all points within a distance.
  static GridBox Around(const GridPoint& point, std::int64_t distance)
  {
    GridBox box;
    box.Low = { { point.X, point.Y, point.X + point.Y, point.X - point.Y } };
    box.High = box.Low;
    for (int k = 0; k < 4; ++k)
    {
      box.Low[k] -= 2 * distance;
      box.High[k] += 2 * distance;
    }
    return box;
  }

  static GridBox Around(const GridSegment& segment)
  {
    GridBox box = Around(segment.From, 0);
    box.Add(Around(segment.To, 0));
    return box;
  }

  bool Meets(const GridBox& other) const
  {
    bool meets = true;
    for (int k = 0; k < 4; ++k)
    {
      meets = meets && this->High[k] >= other.Low[k] && other.High[k] >= this->Low[k];
    }
    return meets;
  }

  void Add(const GridBox& other)
  {
    for (int k = 0; k < 4; ++k)
    {
      this->Low[k] = std::min(this->Low[k], other.Low[k]);
      this->High[k] = std::max(this->High[k], other.High[k]);
    }
  }

  /// Returns the direction of largest extent.
  int FindWidest() const
  {
    int widest = 0;
    for (int k = 1; k < 4; ++k)
    {
      const bool isWider = this->High[k] - this->Low[k] > this->High[widest] - this->Low[widest];
      widest = isWider ? k : widest;
    }
    return widest;
  }
};

/// A binary tree of bounding boxes in which each segment is stored once, whether long or in a
/// cluster of short ones.
class SegmentTree
{
public:
  void Build(const std::vector<GridSegment>& segments)
  {
    this->Boxes.clear();
    for (const GridSegment& segment : segments)
    {
      this->Boxes.push_back(GridBox::Around(segment));
    }
    this->Order.resize(segments.size());
    std::iota(this->Order.begin(), this->Order.end(), 0);
    this->Nodes.clear();
    if (!segments.empty())
    {
      this->Nodes.push_back({ {}, 0, segments.size(), 0 });
    }
    for (std::size_t n = 0; n < this->Nodes.size(); ++n)
    {
      this->SplitNode(n);
    }
  }

  /// Finds the segments whose boxes intersect a box, in increasing order.
  void Find(const GridBox& box, std::vector<std::size_t>& found)
  {
    found.clear();
    this->Stack.assign(this->Nodes.empty() ? 0 : 1, 0);
    while (!this->Stack.empty())
    {
      const Node& node = this->Nodes[this->Stack.back()];
      this->Stack.pop_back();
      if (!node.Box.Meets(box))
      {
        continue;
      }
      if (node.Children > 0)
      {
        this->Stack.push_back(node.Children);
        this->Stack.push_back(node.Children + 1);
      }
      else
      {
        std::copy_if(this->Order.begin() + static_cast<std::ptrdiff_t>(node.Begin),
          this->Order.begin() + static_cast<std::ptrdiff_t>(node.End), std::back_inserter(found),
          [&](std::size_t s) { return this->Boxes[s].Meets(box); });
      }
    }
    std::sort(found.begin(), found.end());
  }

private:
  struct Node
  {
    GridBox Box;
    std::size_t Begin; // range of its segments
    std::size_t End;
    std::size_t Children; // first of two children; 0 for leaves
  };

  /// Splits a node at the median of the box centers, along the direction of largest extent.
  void SplitNode(std::size_t number)
  {
    Node node = this->Nodes[number];
    const auto begin = this->Order.begin() + static_cast<std::ptrdiff_t>(node.Begin);
    const auto end = this->Order.begin() + static_cast<std::ptrdiff_t>(node.End);
    node.Box = this->Boxes[*begin];
    std::for_each(begin, end, [&](std::size_t s) { node.Box.Add(this->Boxes[s]); });
    if (node.End - node.Begin > LeafSize)
    {
      const int widest = node.Box.FindWidest();
      const auto key = [&](std::size_t s) {
        const GridBox& box = this->Boxes[s];
        return std::make_pair(box.Low[widest] + box.High[widest], s);
      };
      const std::size_t middle = node.Begin + (node.End - node.Begin) / 2;
      std::nth_element(begin, this->Order.begin() + static_cast<std::ptrdiff_t>(middle), end,
        [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
      node.Children = this->Nodes.size();
      this->Nodes.push_back({ {}, node.Begin, middle, 0 });
      this->Nodes.push_back({ {}, middle, node.End, 0 });
    }
    this->Nodes[number] = node;
  }

  std::vector<GridBox> Boxes; // per segment
  std::vector<std::size_t> Order;
  std::vector<Node> Nodes;
  std::vector<std::size_t> Stack;
};

/// Returns true if a point is close to a segment, between its ends.
bool IsBetween(const GridPoint& p, const GridSegment& segment)
{
  const auto real = [](std::int64_t x) { return static_cast<double>(x); };
  const double ux = real(segment.To.X - segment.From.X);
  const double uy = real(segment.To.Y - segment.From.Y);
  const double vx = real(p.X - segment.From.X);
  const double vy = real(p.Y - segment.From.Y);
  const double square = ux * ux + uy * uy;
  const double along = ux * vx + uy * vy;
  return along > 0.0 && along < square &&
    std::abs(ux * vy - uy * vx) <= real(PathNodes::MergeDistance) * std::sqrt(square);
}

/// Returns the position of a point along a segment, in squared grid units.
double Along(const GridPoint& p, const GridSegment& segment)
{
  const auto real = [](std::int64_t x) { return static_cast<double>(x); };
  return real(segment.To.X - segment.From.X) * real(p.X - segment.From.X) +
    real(segment.To.Y - segment.From.Y) * real(p.Y - segment.From.Y);
}

GridPoint Intersection(const GridSegment& first, const GridSegment& second)
{
  const auto real = [](std::int64_t x) { return static_cast<long double>(x); };
  const GridPoint& a = first.From;
  const long double ux = real(first.To.X - a.X);
  const long double uy = real(first.To.Y - a.Y);
  const long double vx = real(second.To.X - second.From.X);
  const long double vy = real(second.To.Y - second.From.Y);
  const long double t =
    (real(second.From.X - a.X) * vy - real(second.From.Y - a.Y) * vx) / (ux * vy - uy * vx);
  GridPoint p{ a.X + std::llround(t * ux), a.Y + std::llround(t * uy) };
  // Not on a side, because the adjacent face would not have the point.
  p.X = std::max<std::int64_t>(1, std::min(p.X, GridPoint::One - 2));
  p.Y = std::max<std::int64_t>(1, std::min(p.Y, GridPoint::One - 1 - p.X));
  return p;
}

bool Contains(const std::vector<Id>& nodes, Id node)
{
  return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
}

void InsertAfter(std::vector<Id>& nodes, std::size_t place, Id node)
{
  nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(place) + 1, node);
}

class PieceSplitter
{
public:
  PieceSplitter(PathNodes& nodes, std::vector<PathPiece>& pieces, bool insertCrossings, Id face)
    : Nodes(nodes)
    , Pieces(pieces)
    , InsertCrossings(insertCrossings)
    , Face(face)
  {
  }

  Status Split(const std::vector<std::size_t>& places, const ProgressCallback& progress)
  {
    double begin = 0.0;
    for (int round = 0; round < MaximumRounds; ++round)
    {
      // Each round gets half of the remaining progress, and so does each iteration of its first
      // half.
      const double share = 0.25 * (1.0 - begin);
      const double middle = begin + share;
      bool found = true;
      while (found)
      {
        for (const std::size_t p : places)
        {
          this->SplitAlongSides(this->Pieces[p].Nodes);
        }
        this->CollectSegments(places);
        const double end = 0.5 * (begin + middle);
        if (!this->SplitAtNodes(ProgressPart(progress, begin, end), found))
        {
          return Status::Abort();
        }
        begin = end;
      }
      Status status = this->SplitAtCrossings(ProgressPart(progress, middle, middle + share), found);
      if (!status.IsOk() || !found)
      {
        return status;
      }
      begin = middle + share;
    }
    return InvalidInput("The crossings of paths in face ", this->Face, " are too close together");
  }

private:
  /// A part of a path segment, between consecutive nodes.
  struct Segment
  {
    std::size_t Piece;
    std::size_t Start; // index of its start among the nodes of the piece
  };

  bool IsOnSide(Id a, Id b, int& side) const
  {
    return !this->Nodes.IsInside(a) && !this->Nodes.IsInside(b) &&
      this->Nodes.AreOnOneSide(a, b, this->Face, side);
  }

  GridSegment LineBetween(Id a, Id b) const
  {
    return { this->Nodes.PlaceOf(a, this->Face), this->Nodes.PlaceOf(b, this->Face) };
  }

  /// Inserts into a piece all nodes that it passes on sides of the face.
  void SplitAlongSides(std::vector<Id>& nodes) const
  {
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      int side = 0;
      if (this->IsOnSide(nodes[i], nodes[i + 1], side))
      {
        const Id next = this->Nodes.FindNextOnSide(nodes[i], nodes[i + 1], this->Face, side);
        if (next != nodes[i + 1])
        {
          InsertAfter(nodes, i, next);
        }
      }
    }
  }

  /// Collects the segments of the pieces, except segments on sides of the face, which nothing
  /// crosses.
  void CollectSegments(const std::vector<std::size_t>& places)
  {
    this->Segments.clear();
    this->Lines.clear();
    for (const std::size_t p : places)
    {
      const std::vector<Id>& nodes = this->Pieces[p].Nodes;
      for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
      {
        int side = 0;
        if (!this->IsOnSide(nodes[i], nodes[i + 1], side))
        {
          this->Segments.push_back({ p, i });
          this->Lines.push_back(this->LineBetween(nodes[i], nodes[i + 1]));
        }
      }
    }
    this->Tree.Build(this->Lines);
  }

  /// Reports progress at one step out of many. Returns false to stop.
  static bool ShouldContinue(const ProgressCallback& progress, std::size_t step, std::size_t steps)
  {
    return step % ProgressInterval != ProgressInterval - 1 || !progress ||
      progress(static_cast<double>(step) / static_cast<double>(steps));
  }

  /// Inserts nodes into segments that pass them, including nodes on sides: otherwise crossings
  /// could be closer to these nodes than the merge distance. `found` becomes true if a node was
  /// inserted; segments must then be collected again, because parts of them may pass other nodes.
  /// Returns false if stopped.
  bool SplitAtNodes(const ProgressCallback& progress, bool& found)
  {
    found = false;
    const std::vector<Id> candidates = this->Nodes.CollectNodes(this->Face);
    std::vector<std::pair<std::size_t, Id>> passed; // segments, and nodes in their order
    std::vector<std::size_t> close;
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      if (!ShouldContinue(progress, i, candidates.size()))
      {
        return false;
      }
      const GridPoint place = this->Nodes.PlaceOf(candidates[i], this->Face);
      this->Tree.Find(GridBox::Around(place, PathNodes::MergeDistance), close);
      for (const std::size_t s : close)
      {
        if (IsBetween(place, this->Lines[s]))
        {
          passed.emplace_back(s, candidates[i]);
        }
      }
    }
    // From the back, so that indices in the lists of nodes remain valid.
    std::stable_sort(passed.begin(), passed.end(),
      [](const auto& first, const auto& second) { return first.first > second.first; });
    std::size_t last = 0; // end of the part of the list that was the segment
    for (std::size_t i = 0; i < passed.size(); ++i)
    {
      const Segment& segment = this->Segments[passed[i].first];
      const bool isNew = i == 0 || passed[i].first != passed[i - 1].first;
      last = isNew ? segment.Start + 1 : last;
      const bool isInserted = this->InsertWhereBetween(
        this->Pieces[segment.Piece].Nodes, segment.Start, last, passed[i].second);
      last += isInserted ? 1 : 0;
      found = found || isInserted;
    }
    return true;
  }

  /// Inserts a node between two nodes of a part of the list, unless it is already there.
  bool InsertWhereBetween(std::vector<Id>& nodes, std::size_t begin, std::size_t end, Id node) const
  {
    const GridPoint place = this->Nodes.PlaceOf(node, this->Face);
    std::size_t n = Contains(nodes, node) ? end : begin;
    while (n < end && !IsBetween(place, this->LineBetween(nodes[n], nodes[n + 1])))
    {
      ++n;
    }
    if (n < end)
    {
      InsertAfter(nodes, n, node);
    }
    return n < end;
  }

  /// Inserts nodes where pieces cross, or fails if crossings must not be inserted.
  Status SplitAtCrossings(const ProgressCallback& progress, bool& found)
  {
    using Insertion = std::tuple<std::size_t, std::size_t, double, Id>; // piece, start, along, node
    std::vector<Insertion> insertions;
    std::vector<std::size_t> close;
    for (std::size_t i = 0; i < this->Segments.size(); ++i)
    {
      if (!ShouldContinue(progress, i, this->Segments.size()))
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
          return InvalidInput("Paths ", this->Pieces[this->Segments[i].Piece].Path, " and ",
            this->Pieces[this->Segments[*j].Piece].Path, " cross in face ", this->Face);
        }
        const Id node = this->Nodes.AddCrossing(Intersection(p, q), this->Face);
        for (const std::size_t s : { i, *j })
        {
          const Segment& segment = this->Segments[s];
          if (!Contains(this->Pieces[segment.Piece].Nodes, node))
          {
            insertions.emplace_back(segment.Piece, segment.Start,
              Along(this->Nodes.PlaceOf(node, this->Face), this->Lines[s]), node);
          }
        }
      }
    }
    // From the back, so that indices in the lists of nodes remain valid.
    std::sort(insertions.begin(), insertions.end(), std::greater<Insertion>());
    for (const Insertion& insertion : insertions)
    {
      std::vector<Id>& nodes = this->Pieces[std::get<0>(insertion)].Nodes;
      if (!Contains(nodes, std::get<3>(insertion)))
      {
        InsertAfter(nodes, std::get<1>(insertion), std::get<3>(insertion));
      }
    }
    found = !insertions.empty();
    return Status::Success();
  }

  PathNodes& Nodes;
  std::vector<PathPiece>& Pieces;
  const bool InsertCrossings;
  const Id Face;
  std::vector<Segment> Segments;
  std::vector<GridSegment> Lines; // positions of the segments
  SegmentTree Tree;               // tree of Lines
};
}

Status SplitPieces(PathNodes& nodes, std::vector<PathPiece>& pieces, bool insertCrossings, Id face,
  const std::vector<std::size_t>& places, const ProgressCallback& progress)
{
  return PieceSplitter(nodes, pieces, insertCrossings, face).Split(places, progress);
}
}
