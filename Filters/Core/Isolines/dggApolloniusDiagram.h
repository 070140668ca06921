// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The additively weighted Voronoi diagram of sites on the boundary of a triangle. Internal.
#ifndef dggApolloniusDiagram_h
#define dggApolloniusDiagram_h

#include "dggUnfolding.h" // for Point2

#include <array>   // for the corners
#include <cstddef> // for std::size_t
#include <utility> // for the ends of edges
#include <vector>  // for the diagram

namespace dgg
{
/// A point on the boundary of the triangle with its initial distance.
struct WeightedSite
{
  int Side = 0;   ///< side from corner Side to the next corner
  double X = 0.0; ///< abscissa on the side, in [0, length)
  double Weight = 0.0;
};

/// A point where edges of the diagram meet or end.
struct ApolloniusNode
{
  Point2 Place;
  double Distance = 0.0; ///< weight + distance, equal for the tied sites
  int Side = -1;         ///< side of the triangle that contains the node; -1 inside
  double X = 0.0;        ///< abscissa on the side
};

/// Cells of weighted sites. A point p belongs to the site with the smallest weight + |p - site|.
/// Cells are star-shaped around their sites: for a direction u, the inverse of the distance to the
/// border with another site is linear in u, and so is the inverse of the distance to a side of the
/// triangle. A cell is therefore an upper envelope of functions of one angle, which requires no
/// triples of sites. Dominated sites have no cell.
///
/// Each cell is computed independently; nodes that several cells find are merged. If many sites
/// tie, rounding may cause missing or shortened edges, but never wrong nodes.
class ApolloniusDiagram
{
public:
  /// Builds the diagram. Corners are in counter-clockwise order.
  void Build(const std::array<Point2, 3>& corners, const std::vector<WeightedSite>& sites);

  const std::vector<ApolloniusNode>& GetNodes() const { return this->Nodes; }
  /// Returns the edges as pairs of nodes.
  const std::vector<std::pair<int, int>>& GetEdges() const { return this->Edges; }

private:
  /// A border as seen from the current site: 1 / distance = A . u - C. The border belongs to
  /// another site, or to a side (~side).
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
