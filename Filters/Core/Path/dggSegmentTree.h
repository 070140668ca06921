// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds segments in a triangle. Internal.
#ifndef dggSegmentTree_h
#define dggSegmentTree_h

#include "dggFaceTriangulation.h" // for GridPoint

#include <array>   // for bounds
#include <cstddef> // for std::size_t
#include <cstdint> // for bounds
#include <vector>  // for segments

namespace dgg
{
struct GridSegment
{
  GridPoint From;
  GridPoint To;
};

/// An octagon on the grid, with its rim: bounds of X, Y, X + Y and X - Y. Boxes around slanted
/// segments side by side would overlap.
struct GridBox
{
  std::array<std::int64_t, 4> Low;
  std::array<std::int64_t, 4> High;

  static GridBox Around(const GridSegment& segment);
  /// Around all points that are this close.
  static GridBox Around(const GridPoint& point, std::int64_t distance);
  bool Meets(const GridBox& other) const;
  void Add(const GridBox& other);
};

/// Segments in a binary tree of the boxes around them, which has a place for each segment: neither
/// long ones nor clusters of short ones are stored twice.
class SegmentTree
{
public:
  void Build(const std::vector<GridSegment>& segments);

  /// The segments whose boxes meet a box, in increasing order.
  void Find(const GridBox& box, std::vector<std::size_t>& found);

private:
  struct Node
  {
    GridBox Box;
    std::size_t Begin; // of its segments
    std::size_t End;
    std::size_t Children; // of two, the first; 0 for leaves
  };

  std::vector<GridBox> Boxes; // per segment
  std::vector<std::size_t> Order;
  std::vector<Node> Nodes;
  std::vector<std::size_t> Stack;
};
}

#endif
