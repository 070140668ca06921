// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The additively weighted Voronoi diagram of sites on the rim of a triangle. Internal.
#ifndef dggApolloniusDiagram_h
#define dggApolloniusDiagram_h

#include "dggUnfolding.h" // for Point2

#include <array>   // for the corners
#include <cstddef> // for std::size_t
#include <utility> // for the ends of edges
#include <vector>  // for the diagram

namespace dgg
{
/// A point on the rim of the triangle, and the distance that it starts with.
struct WeightedSite
{
  int Side = 0;   ///< from corner Side to the next one
  double X = 0.0; ///< abscissa on it, from 0 (the corner) on and less than the length
  double Weight = 0.0;
};

/// Where a diagram's edges meet or end.
struct ApolloniusNode
{
  Point2 Place;
  double Distance = 0.0; ///< weight + distance of the sites that tie
  int Side = -1;         ///< of the triangle on which it lies; -1 inside
  double X = 0.0;        ///< abscissa on the side
};

/// A point p belongs to the site of least weight + |p - site|. Cells are stars around their sites:
/// with u a direction, the inverse of the distance to the border with another site is linear in u,
/// and so is that to a side of the triangle. A cell is therefore found by following the upper
/// envelope of some functions of one angle, which needs no triples of sites. Sites that are within
/// reach of another one have no cell.
///
/// Each cell is found on its own; what several cells say about a node is merged. With ties of many
/// sites rounding may let edges be missing or short of their ends, never nodes be wrong.
class ApolloniusDiagram
{
public:
  /// Corners counter-clockwise.
  void Build(const std::array<Point2, 3>& corners, const std::vector<WeightedSite>& sites);

  const std::vector<ApolloniusNode>& GetNodes() const { return this->Nodes; }
  /// Edges as pairs of nodes.
  const std::vector<std::pair<int, int>>& GetEdges() const { return this->Edges; }

private:
  /// A border seen from the site at work: 1 / distance = A . u - C. A site, or ~side.
  struct Border
  {
    Point2 A;
    double C;
    int Name;
  };

  void DropDominated();
  void FollowCell(std::size_t i);
  void CollectBorders(std::size_t i, const Point2& axis);
  std::size_t FindOutermost(double angle) const;
  bool FindNext(std::size_t current, double angle, double end, std::size_t& next, double& at) const;
  int AddNode(const Point2& place, double distance, int side);

  std::array<Point2, 3> Corners;
  std::array<Point2, 3> Axes;
  std::array<double, 3> Lengths{ { 0.0, 0.0, 0.0 } };
  double Scale = 0.0;
  std::vector<WeightedSite> Sites;
  std::vector<Point2> Places;
  std::vector<bool> IsDropped;
  std::vector<Border> Borders;
  std::vector<ApolloniusNode> Nodes;
  std::vector<std::pair<int, int>> Edges;
};
}

#endif
