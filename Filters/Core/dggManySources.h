// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Searches from several sources at once. Internal.
#ifndef dggManySources_h
#define dggManySources_h

#include "dggBucketQueue.h"   // for BucketQueue
#include "dggGeodesicGraph.h" // for GraphView
#include "dggLanes.h"         // for Lanes

#include <vector> // for the labels

namespace dgg
{
/// Distances from up to Lanes::Size sources, each on its own, in one search: a vertex is taken from
/// the queue for all of them, and an edge is read once for all of them. This pays when the sources
/// are close together, so that their waves come by at about the same time.
class ManySources
{
public:
  explicit ManySources(const GraphView& graph, double bucketWidth);

  /// `rows[k]` receives the distances from sources[k], Infinity beyond the radius.
  void Run(const Id* sources, int count, double radius, double* const* rows);

private:
  template <typename Length>
  void Propagate(const Length* lengths);
  void Enter(Id v, double label);

  const GraphView& Graph;
  double BucketWidth;
  double Radius = Infinity;
  std::vector<Lanes> Labels;
  std::vector<float>
    Pending; ///< key under which a vertex waits in the queue; Infinity if it does not
  BucketQueue Queue;
};
}

#endif
