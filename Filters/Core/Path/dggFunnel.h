// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The shortest path in a strip of faces. Internal.
#ifndef dggFunnel_h
#define dggFunnel_h

#include "dggStripUnfolding.h" // for StripUnfolding

#include <vector> // for the funnel

namespace dgg
{
/// Where a path touches the border of its strip.
struct StripBend
{
  std::size_t Portal; ///< the first one with this end
  int Side;           ///< StripUnfolding::Left or Right
  Point2 Position;
};

/// Shortest paths in unfolded strips, in linear time: the funnel between the shortest paths to both
/// ends of a portal, carried from portal to portal (Lee and Preparata, "Euclidean shortest paths in
/// the presence of rectilinear barriers", 1984, sec. 2). Keeps its memory from call to call.
class Funnel
{
public:
  /// The points where the path from start to end bends, or at least touches a vertex, in order.
  /// Returns its length.
  double Run(const StripUnfolding& strip, std::vector<StripBend>& bends);

private:
  /// A point of the funnel. Its parent is the point before it on the shortest path to it.
  struct Node
  {
    StripBend Bend;
    std::size_t Parent;
  };

  std::size_t Attach(int side, const StripBend& point);
  std::size_t& End(int side) { return side == StripUnfolding::Left ? this->First : this->Last; }
  const Point2& Position(std::size_t place) const
  {
    return this->Nodes[this->Deque[place]].Bend.Position;
  }

  std::vector<Node> Nodes;
  /// Nodes from the left end of the funnel over its apex to the right end.
  std::vector<std::size_t> Deque;
  std::size_t First = 0;
  std::size_t Apex = 0;
  std::size_t Last = 0;
};
}

#endif
