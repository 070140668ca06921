// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Better estimates of the distance than the lengths of graph paths. Internal.
#ifndef dggLabelCorrection_h
#define dggLabelCorrection_h

#include "dggSearchLabels.h" // for GraphSeed, SearchResult, TreeStep
#include "dggSurfaceMesh.h"  // for SurfaceMesh

#include <algorithm> // for the interval
#include <vector>    // for the vertices

namespace dgg
{
/// How far an exact distance may be below a label, as a factor; 0 when labels do not certify it.
inline double LabelShrink(const GraphInfo& info)
{
  return info.IsGuaranteed() ? 1.0 / (1.0 + info.Accuracy) : 0.0;
}

/// A label certifies an interval, in which the estimate has to be, whatever the curvature did to
/// it.
inline double ClampToLabel(double estimate, double label, double smallestOffset, double shrink)
{
  const double lowest =
    shrink > 0.0 ? smallestOffset + (label - smallestOffset) * shrink : -Infinity;
  return std::min(std::max(estimate, lowest), label);
}

/// A path in the graph zigzags about the geodesic that it approximates. Unfolded edge by edge into
/// the plane it can be straightened: down the tree of paths, each vertex receives the virtual
/// source of the path. Where the path bends, the vertex of the bend becomes the virtual source of
/// the vertices behind it.
class LabelCorrection
{
public:
  /// Virtual source of a vertex, and the estimate of the distance that follows from it.
  struct Estimate
  {
    VirtualSource Source;
    double Distance;
  };

  LabelCorrection(const GraphView& graph, const SurfaceMesh& mesh);

  /// Fills Corrected and Virtual of a finished search at the vertices that are reached, from its
  /// tree.
  void Run(const std::vector<GraphSeed>& seeds, const std::vector<TreeStep>& steps,
    SearchResult& result) const;

  /// Returns the estimate of one vertex that is reached over an edge, given that of the tail: for a
  /// label besides those of a search. `smallestOffset` is that of all seeds.
  Estimate Extend(
    const TreeStep& step, double label, const Estimate& tail, double smallestOffset) const;

  /// Returns the distance that the source of a seed starts with.
  static double OffsetOf(const GraphSeed& seed);
  /// Returns the estimate of the vertex of a seed.
  static Estimate EstimateOf(const GraphSeed& seed);

private:
  struct Vertex
  {
    float Angle = 0.0f;  ///< total angle: positive inside, negative on the boundary, 0 if irregular
    float Defect = 0.0f; ///< absolute value of the angle defect
  };

  static double FindSmallestOffset(const std::vector<GraphSeed>& seeds);
  template <typename Length>
  void Straighten(const Length* lengths, const std::vector<GraphSeed>& seeds,
    const std::vector<TreeStep>& steps, SearchResult& result) const;
  Estimate Follow(const TreeStep& step, double edge, const Estimate& from) const;

  const GraphView& Graph;
  std::vector<Vertex> Vertices;
  double Shrink; ///< to the smallest distance that a label certifies; 0 when it does not
  double Unseen; ///< mean gain of an edge on a rough surface by what is not seen
};
}

#endif
