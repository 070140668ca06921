// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A strip of faces unfolded into the plane. Internal.
#ifndef dggStripUnfolding_h
#define dggStripUnfolding_h

#include "dggStrip.h"     // for Strip
#include "dggUnfolding.h" // for Point2

#include <array>  // for the sides
#include <vector> // for the portals

namespace dgg
{
/// An edge that the strip crosses, in the plane.
struct Portal
{
  /// Ends of the edge, left and right in the direction of the strip.
  std::array<Point2, 2> Ends;
  std::array<Id, 2> Vertices{ { NoId, NoId } };
};

/// The faces of a strip unfolded into one plane without flips: a face of opposite orientation is
/// laid out as its mirror image.
struct StripUnfolding
{
  static constexpr int Left = 0;
  static constexpr int Right = 1;

  Point2 Start;
  Point2 End;
  std::vector<Portal> Portals; ///< per crossing

  void Unfold(const SurfaceMesh& mesh, const Strip& strip);
};

/// A point where a path touches the border of its strip.
struct StripBend
{
  std::size_t Portal; ///< first portal with this end
  int Side;           ///< StripUnfolding::Left or Right
  Point2 Position;
};

/// Shortest paths in unfolded strips in linear time, by the funnel algorithm (Lee and Preparata,
/// "Euclidean shortest paths in the presence of rectilinear barriers", 1984, sec. 2): the funnel
/// between the shortest paths to both ends of a portal is advanced from portal to portal. Buffers
/// are reused between calls.
class Funnel
{
public:
  /// Finds the points where the path from start to end bends or touches a vertex, in order. Returns
  /// the length of the path.
  double Run(const StripUnfolding& strip, std::vector<StripBend>& bends);

private:
  /// A point of the funnel. Its parent is the previous point on the shortest path to it.
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
