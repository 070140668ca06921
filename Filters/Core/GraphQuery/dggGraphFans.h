// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Restricts the edges that can follow an edge on a shortest path. Internal.
#ifndef dggGraphFans_h
#define dggGraphFans_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggPrefetch.h"      // for Prefetch
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include <algorithm> // for std::max
#include <cstdint>   // for the degree
#include <vector>    // for the vertices

namespace dgg
{
///@{
/// Returns the largest angle between an edge of a guaranteed graph and the geodesic that the edge
/// approximates; for other graphs, an empirical value.
double LargestDeviation(const GraphView& graph);
double LargestDeviation(const GraphInfo& graph, double meanDegree);
///@}

/// Angles around a vertex.
struct VertexAngle
{
  float Total = 0.0f;  ///< positive inside, negative on the boundary, 0 if irregular or isolated
  float Defect = 0.0f; ///< inside, the absolute value of the angle defect
};

std::vector<VertexAngle> MeasureVertexAngles(const SurfaceMesh& mesh);

/// Finds the edges that can follow an edge on a shortest path. A shortest path continues nearly
/// straight, so that only the edges of a row are relevant that leave roughly opposite to the
/// direction of arrival: the fan of this direction. Rows are sorted by angle, so that a fan is
/// found by interpolation and a few steps, without storing data per edge.
///
/// The restriction is a heuristic, not a theorem: callers have to certify the result.
class GraphFans
{
public:
  GraphFans(const GraphView& graph, const SurfaceMesh& mesh);
  GraphFans(
    const GraphView& graph, const std::vector<VertexAngle>& angles, double largestDeviation);

  /// Returns true if locating the fan in a row costs less than relaxing the entire row.
  static bool AreWorthwhile(const GraphView& graph);

  /// Calls `relax(edge)` for the edges of the fan of a vertex that was reached from the direction
  /// `arrival`; negative means that every edge may follow.
  template <typename Relax>
  void ForEach(Id v, float arrival, const Relax& relax) const
  {
    this->ForEachBeyond(v, arrival, this->Vertices[v].Lead, relax);
  }

  /// Like ForEach(), with a given minimum angle between arrival and departure; 0 allows all edges.
  template <typename Relax>
  void ForEachBeyond(Id v, float arrival, float lead, const Relax& relax) const
  {
    const Vertex& vertex = this->Vertices[v];
    if (arrival < 0.0f || lead <= 0.0f)
    {
      for (Offset e = vertex.Begin; e < vertex.Begin + vertex.Degree; ++e)
      {
        relax(e);
      }
      return;
    }
    // Departures are at an angle of at least `lead` from the arrival on either side, modulo the
    // total angle.
    if (vertex.Guess(arrival + lead) < vertex.Degree)
    {
      this->ForRange(vertex, arrival + lead, arrival + vertex.Turn - lead, relax);
    }
    if (arrival >= lead)
    {
      this->ForRange(vertex, arrival - vertex.Turn + lead, arrival - lead, relax);
    }
  }

  /// Prefetches a vertex.
  void PrefetchVertex(Id v) const { Prefetch(&this->Vertices[v]); }

  /// Prefetches a fan; the vertex should be in the cache already.
  template <typename Length>
  void PrefetchFan(const GraphView& graph, const Length* lengths, Id v, float arrival) const
  {
    const Vertex& vertex = this->Vertices[v];
    Offset guess = vertex.Guess(arrival + vertex.Lead);
    if (guess >= vertex.Degree)
    {
      guess = vertex.Guess(arrival + vertex.Lead - vertex.Turn);
    }
    // A fan has about six edges.
    for (Offset e : { vertex.Begin + guess - 2, vertex.Begin + guess + 7 })
    {
      Prefetch(graph.Targets + e);
      Prefetch(lengths + e);
      Prefetch(graph.Angles + e);
      Prefetch(graph.ArrivalAngles + e);
    }
  }

private:
  struct Vertex
  {
    Offset Begin = 0; ///< first edge of the row
    std::uint32_t Degree = 0;
    float Lead = 0.0f;     ///< minimum angle between arrival and departure; 0 allows all
    float Turn = 0.0f;     ///< total angle, the period of directions
    float PerAngle = 0.0f; ///< mean number of edges per radian

    /// Returns the approximate number of edges that leave at a smaller angle.
    Offset Guess(float angle) const
    {
      return static_cast<Offset>(std::max(0.0f, angle * this->PerAngle));
    }
  };

  /// Calls `relax` for the edges with angles in [low, high].
  template <typename Relax>
  void ForRange(const Vertex& vertex, float low, float high, const Relax& relax) const
  {
    const Offset begin = vertex.Begin;
    const Offset end = begin + vertex.Degree;
    Offset e = begin + std::min<Offset>(vertex.Guess(low), vertex.Degree);
    while (e > begin && this->Angles[e - 1] >= low)
    {
      --e;
    }
    while (e < end && this->Angles[e] < low)
    {
      ++e;
    }
    for (; e < end && this->Angles[e] <= high; ++e)
    {
      relax(e);
    }
  }

  std::vector<Vertex> Vertices;
  const float* Angles;
  float Tolerance;
};
}

#endif
