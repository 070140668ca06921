// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shortest paths of the Parallel Boost Graph Library on several processes: delta-stepping (Meyer
/// and Sanders, "Delta-stepping: a parallelizable shortest path algorithm", 2003). Boost's headers
/// are included in the source file only.
#ifndef PeerBoost_h
#define PeerBoost_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggStoredGraph.h"   // for GhostVertices

#include <memory> // for the implementation
#include <vector> // for the distances

class PeerBoost
{
public:
  /// Copies the rows of this process. `ids` are global ids per vertex of the rows. All functions
  /// must be called by all processes.
  PeerBoost(const dgg::GraphView& rows, const std::vector<dgg::Offset>& ids,
    const dgg::GhostVertices& ghosts);
  ~PeerBoost();
  PeerBoost(const PeerBoost&) = delete;
  PeerBoost& operator=(const PeerBoost&) = delete;

  /// Computes the distances from a vertex, given by its global id. `width` is that of buckets, in
  /// mean lengths of edges.
  void Run(dgg::Offset source, double width);
  /// Returns the distances of the last run per vertex of the rows; NaN for ghosts.
  std::vector<double> GetDistances() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Internals;
};

#endif
