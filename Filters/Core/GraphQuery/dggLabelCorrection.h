// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distance estimates that are more accurate than the lengths of graph paths. Internal.
#ifndef dggLabelCorrection_h
#define dggLabelCorrection_h

#include "dggGraphFans.h"    // for the angles
#include "dggPrefetch.h"     // for Prefetch
#include "dggSearchLabels.h" // for GraphSeed, SearchResult, TreeStep
#include "dggSurfaceMesh.h"  // for SurfaceMesh

#include <algorithm> // for the interval
#include <cstddef>   // for std::size_t
#include <vector>    // for the vertices

namespace dgg
{
/// Returns the smallest possible ratio of the exact distance to a label; 0 if labels certify no
/// lower bound.
inline double LabelShrink(const GraphInfo& info)
{
  return info.IsGuaranteed() ? 1.0 / (1.0 + info.Accuracy) : 0.0;
}

/// Returns an estimate clamped to the interval that a label certifies, since curvature may distort
/// the estimate.
inline double ClampToLabel(double estimate, double label, double smallestOffset, double shrink)
{
  const double lowest =
    shrink > 0.0 ? smallestOffset + (label - smallestOffset) * shrink : -Infinity;
  return std::min(std::max(estimate, lowest), label);
}

/// Improves distances by straightening paths. A graph path zigzags around the geodesic that it
/// approximates. Unfolded edge by edge into the plane, the path can be straightened: along the tree
/// of paths, each vertex receives the virtual source of its path. If the path bends, the vertex of
/// the bend becomes the virtual source of the vertices behind the bend.
class LabelCorrection
{
public:
  /// Virtual source of a vertex, and the resulting distance estimate.
  struct Estimate
  {
    VirtualSource Source;
    double Distance;
  };

  LabelCorrection(const GraphView& graph, const SurfaceMesh& mesh);
  LabelCorrection(const GraphView& graph, std::vector<VertexAngle> angles, double largestDeviation,
    double meanEdgeLength);

  /// Fills Corrected and Virtual of a finished search at the reached vertices, from the search
  /// tree.
  void Run(const std::vector<GraphSeed>& seeds, const std::vector<TreeStep>& steps,
    SearchResult& result) const;

  /// Returns the estimate of a vertex that is reached over an edge, given the estimate of the tail;
  /// `label` need not be a label of the search. `smallestOffset` is the minimum over all seeds.
  Estimate Extend(
    const TreeStep& step, double label, const Estimate& tail, double smallestOffset) const;

  /// Number of steps by which data is prefetched.
  static constexpr std::size_t Lookahead = 8;
  /// Loads the edge and the angles of a step into the cache.
  void PrefetchStep(const TreeStep& step) const
  {
    WithLengths(this->Graph, [&](const auto* lengths) { Prefetch(lengths + step.Edge); });
    Prefetch(this->Graph.Angles + step.Edge);
    Prefetch(this->Graph.ArrivalAngles + step.Edge);
    Prefetch(&this->Angles[step.Tail]);
    Prefetch(&this->Angles[step.Vertex]);
  }

  /// Returns the initial distance of the source of a seed.
  static double OffsetOf(const GraphSeed& seed);
  /// Returns the estimate at the vertex of a seed.
  static Estimate EstimateOf(const GraphSeed& seed);

private:
  static double FindSmallestOffset(const std::vector<GraphSeed>& seeds);
  template <typename Length>
  void Straighten(const Length* lengths, const std::vector<GraphSeed>& seeds,
    const std::vector<TreeStep>& steps, SearchResult& result) const;
  Estimate Follow(const TreeStep& step, double edge, const Estimate& from) const;

  const GraphView& Graph;
  std::vector<VertexAngle> Angles;
  double Shrink; ///< see LabelShrink()
  double Unseen; ///< mean shortening of an edge by unresolved roughness
  double Scale;  ///< power of two that makes lengths comparable to 1, as floats need it
};
}

#endif
