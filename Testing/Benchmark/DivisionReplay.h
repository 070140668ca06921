// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Messages of a division of a surface into pieces, predicted on one process.
#ifndef DivisionReplay_h
#define DivisionReplay_h

#include "MeshArrays.h" // for the mesh

#include "dggGeodesicGraph.h" // for the graph
#include "dggGraphSearch.h"   // for the trees

#include <set>    // for the processes
#include <vector> // for the layers

/// Returns the mean reach of edges in units of the mean spacing of vertices, the square root of the
/// area per vertex. The reach of a vertex in a direction is the largest component of its edges in
/// this direction. On average over straight cuts, the number of vertices at the ends of edges that
/// cross a cut, on each side, is the reach times the number of spacings along the cut.
double MeasureReach(const MeshArrays& mesh, const dgg::GeodesicGraph& graph);

/// Follows the edges of a graph, and the trees of queries, across pieces that `labels` assigns the
/// triangles to.
class DivisionReplay
{
public:
  DivisionReplay(const MeshArrays& mesh, const std::vector<int>& labels,
    const dgg::GeodesicGraph& graph, const std::vector<dgg::SearchResult>& results);

  double Ghosts = 0.0;
  double LabelRounds = 0.0; ///< mean of all queries
  double TreeRounds = 0.0;
  double Depth = 0.0; ///< layers of cells around a piece that are the entire surface
  /// Per process, the layer of cells around its piece at which the farthest edge ends.
  std::vector<double> Layers;

private:
  void FindGhosts(const dgg::GeodesicGraph& graph);
  void FindLayers(const MeshArrays& mesh, const dgg::GeodesicGraph& graph);
  void AddRounds(const dgg::SearchResult& result, double queries);

  std::vector<std::set<int>> Holders; // per vertex, the pieces with triangles at it
  std::vector<int> Owners;            // per vertex, the process that it belongs to
};

#endif
