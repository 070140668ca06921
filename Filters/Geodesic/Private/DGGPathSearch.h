// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths for many pairs of points. Internal.
#ifndef DGGPathSearch_h
#define DGGPathSearch_h

#include "dggPathFinder.h"   // for FoundPath
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the pairs

class DGGGraphUser;
namespace dgg
{
class PreparedSurface;
}
struct DGGContext;

/// Points between which a path is wanted.
struct DGGPointPair
{
  dgg::SurfacePoint From;
  dgg::SurfacePoint To;
};

/// Find paths, one for each pair, on all threads.
class DGGPathSearch
{
public:
  using Pairs = std::vector<DGGPointPair>;
  using Paths = std::vector<dgg::FoundPath>;

  DGGPathSearch(const DGGContext& context, const Pairs& pairs);

  /// In a graph that is up to date, of a surface whose positions have been made.
  dgg::Status RunInGraph(DGGGraphUser& graph, dgg::PathOptions options, Paths& paths) const;
  /// The same in the graph of a cloud, without faces: from point to point of the cloud, or with
  /// `smooth` not, unless that is longer than the way in the graph. The length is that of the
  /// polyline, which is shorter than that in the graph where the surface is curved.
  dgg::Status RunOnCloud(DGGGraphUser& graph, bool smooth, Paths& paths) const;
  /// Exact ones. Their lengths in the graph are NaN.
  dgg::Status RunExact(Paths& paths) const;

private:
  dgg::Status FindOnCloud(const DGGGraphUser& graph, const DGGPointPair& pair, bool smooth,
    const dgg::ProgressCallback& progress, dgg::FoundPath& found) const;

  const DGGContext& Context;
  const dgg::PreparedSurface& Mesh;
  const Pairs& PointPairs;
};

#endif
