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
/// the plane it can be pulled straight: down the tree of paths, each vertex gets the place of the
/// source as seen from itself, a virtual source at some distance in some direction. Where the path
/// bends, the vertex of the bend becomes the virtual source of what comes after.
class LabelCorrection
{
public:
  /// Where a vertex sees the source, and what follows for its distance.
  struct VirtualSource
  {
    double Offset;   ///< distance at the virtual source
    double Length;   ///< straight distance from it
    double Angle;    ///< polar angle towards it, not reduced to one turn
    double Estimate; ///< of the distance of the vertex
  };

  LabelCorrection(const GraphView& graph, const SurfaceMesh& mesh);

  /// Fill the estimates of a finished search at the vertices that are reached, from its tree.
  /// `sources` is working memory.
  void Run(const std::vector<GraphSeed>& seeds, const std::vector<TreeStep>& steps,
    std::vector<VirtualSource>& sources, SearchResult& result) const;

  /// The same for one vertex that is reached over an edge of which the virtual source at the tail
  /// is known: for a label besides those of a search. `smallestOffset` is that of all seeds.
  VirtualSource Extend(
    const TreeStep& step, double label, const VirtualSource& tail, double smallestOffset) const;

  /// The distance that a seed's source starts with, and where the vertex of a seed sees it.
  static double OffsetOf(const GraphSeed& seed);
  static VirtualSource SourceOf(const GraphSeed& seed);

private:
  /// What matters of a vertex of the mesh.
  struct Vertex
  {
    float Angle = 0.0f;  ///< total angle: positive inside, negative on the boundary, 0 if irregular
    float Defect = 0.0f; ///< how far the surface is from flat there
  };

  static double FindSmallestOffset(const std::vector<GraphSeed>& seeds);
  template <typename Length>
  void Straighten(const Length* lengths, const std::vector<GraphSeed>& seeds,
    const std::vector<TreeStep>& steps, std::vector<VirtualSource>& sources,
    const SearchResult& result) const;
  VirtualSource Follow(const TreeStep& step, double edge, const VirtualSource& from) const;

  const GraphView& Graph;
  std::vector<Vertex> Vertices;
  double Shrink; ///< to the smallest distance that a label certifies; 0 when it does not
  double Unseen; ///< mean gain of an edge on a rough surface by what is not seen
};
}

#endif
