// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How sharply a shortest path in a guaranteed graph can turn. Internal.
#ifndef dggTurnLimits_h
#define dggTurnLimits_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggPrefetch.h"      // for Prefetch
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include <vector> // for the vertices

namespace dgg
{
/// A path over edges of lengths a and b that meet in vertex u at an angle phi on the surface is not
/// a shortest one when phi is small. Around u, up to the nearest opposite edge of its faces, the
/// surface is a cone; so cutting the corner at the distance x of that edge saves
/// 2x (1 - sin(phi / 2)). In a guaranteed graph there is a way that is longer than this short-cut
/// by no more than its accuracy, and shorter than a + b if phi is below a limit.
///
/// Unlike the fans of GraphFans this is a theorem: a search that keeps to it finds all distances.
class TurnLimits
{
public:
  TurnLimits(const GraphView& graph, const SurfaceMesh& mesh);

  /// Whether there can be limits at all.
  static bool AreKnown(const GraphView& graph);

  /// Smallest angle between arrival over an edge of this length and departure; 0 allows all.
  float SmallestAngle(Id v, float arrivalLength) const;

  /// Ask for the memory of a vertex.
  void PrefetchVertex(Id v) const { Prefetch(&this->Vertices[v]); }

private:
  struct Vertex
  {
    float PerLength = 0.0f;   ///< what a unit of length costs of the sine; 0: there is no limit
    float LongestEdge = 0.0f; ///< of the row
  };

  std::vector<Vertex> Vertices;
};
}

#endif
