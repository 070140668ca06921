// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bounds how sharply a shortest path in a guaranteed graph can turn. Internal.
#ifndef dggTurnLimits_h
#define dggTurnLimits_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggPrefetch.h"      // for Prefetch
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include <vector> // for the vertices

namespace dgg
{
/// Limits of the angle by which a shortest path turns. A path over edges of lengths a and b that
/// meet in vertex u at an angle phi on the surface is not a shortest path if phi is small. Around
/// u, up to the nearest opposite edge of its faces, the surface is a cone; cutting the corner at
/// the distance x of this edge saves 2x (1 - sin(phi / 2)). A guaranteed graph has a path that
/// exceeds this shortcut by at most the accuracy, and that is shorter than a + b if phi is below a
/// limit.
///
/// Unlike the fans of GraphFans, the limits are a theorem: a search that respects the limits finds
/// all distances.
class TurnLimits
{
public:
  TurnLimits(const GraphView& graph, const SurfaceMesh& mesh);

  /// Returns true if limits exist for the graph.
  static bool AreKnown(const GraphView& graph);

  /// Returns the minimum angle between arrival over an edge of the given length and departure; 0
  /// allows all edges.
  float SmallestAngle(Id v, float arrivalLength) const;

  /// Prefetches a vertex.
  void PrefetchVertex(Id v) const { Prefetch(&this->Vertices[v]); }

private:
  struct Vertex
  {
    float PerLength = 0.0f;   ///< decrease of the sine per unit of length; 0: no limit
    float LongestEdge = 0.0f; ///< longest edge of the row
  };

  std::vector<Vertex> Vertices;
};
}

#endif
