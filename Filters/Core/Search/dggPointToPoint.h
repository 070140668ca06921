// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance of two points in a graph. Internal.
#ifndef dggPointToPoint_h
#define dggPointToPoint_h

#include "dggMinimumHeap.h"  // for MinimumHeap
#include "dggSearchLabels.h" // for GraphSeed

#include <vector> // for the labels

namespace dgg
{
/// A* from both sides: two searches, each drawn towards the other end by the straight-line distance
/// to it (potentials that agree, so that they can meet: Ikeda et al., "A fast algorithm for finding
/// better routes by AI search techniques", 1994). Keeps its memory from call to call; what a call
/// costs depends on the vertices between the points, not on the size of the graph.
class PointToPoint
{
public:
  explicit PointToPoint(Id numberOfVertices);

  /// Infinity when the two sets of seeds are not connected. `positions`, x y z per vertex, may be
  /// null: then the searches are not drawn anywhere.
  double Run(const GraphView& graph, const std::vector<GraphSeed>& from,
    const std::vector<GraphSeed>& to, const double* positions);

  std::size_t GetMemorySize() const;

private:
  struct Vertex
  {
    double Distance[2] = { Infinity, Infinity }; ///< from either side
    double Potential = 0.0;                      ///< of side 0; that of side 1 is its negative
  };

  void Forget();
  void Start(int side, const std::vector<GraphSeed>& seeds);
  template <typename Length>
  void Expand(const GraphView& graph, const Length* lengths, int side);
  void Lower(Id v, int side, double distance);

  std::vector<Vertex> Vertices;
  std::vector<Id> Touched;
  MinimumHeap Heaps[2];
  const double* Positions = nullptr;
  double Centers[2][3] = {};
  double Best = Infinity;
};
}

#endif
