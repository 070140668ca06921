// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths for many pairs of points. Internal.
#ifndef dggPathSearch_h
#define dggPathSearch_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggPathFinder.h"   // for FoundPath
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the pairs

namespace dgg
{
class GraphSession;
struct CellArrays;
struct Output;
struct TaskContext;

/// Ends of a path.
struct PointPair
{
  SurfacePoint From;
  SurfacePoint To;
};

/// Finds a path for each pair of points, in parallel.
class DGG_CORE_EXPORT PathSearch
{
public:
  using Pairs = std::vector<PointPair>;
  using Paths = std::vector<FoundPath>;

  /// `context` and `pairs` must outlive the search.
  PathSearch(const TaskContext& context, const Pairs& pairs);

  /// Finds paths in a graph that is up to date, on a mesh.
  Status RunInGraph(GraphSession& graph, PathOptions options, Paths& paths) const;
  /// Finds paths in the graph of a cloud, as polylines through points of the cloud. With `smooth`,
  /// polylines are straightened within the band, unless straightening makes them longer than the
  /// path in the graph. The length is the length of the polyline, which is shorter than the length
  /// in the graph where the surface is curved.
  Status RunOnCloud(GraphSession& graph, bool smooth, Paths& paths) const;
  /// Finds exact paths. Their lengths in the graph are NaN.
  Status RunExact(Paths& paths) const;

private:
  Status FindOnCloud(const GraphSession& graph, const PointPair& pair, bool smooth,
    const ProgressCallback& progress, FoundPath& found) const;

  const TaskContext& Context;
  const Pairs& PointPairs;
};

/// Appends the first and the last point id of each line to `ends`. Fails for a line without points
/// and for an id that is out of range.
DGG_CORE_EXPORT Status ReadPathEnds(
  const CellArrays& lines, Offset numberOfPoints, std::vector<Offset>& ends);

///@{
/// Return the pairs of successive points, and the total number of fallbacks of paths.
DGG_CORE_EXPORT PathSearch::Pairs MakePairs(const std::vector<SurfacePoint>& ends);
DGG_CORE_EXPORT Offset CountFallbacks(const PathSearch::Paths& paths);
///@}

/// Writes the lines of the paths that exist, with the cell arrays `Length`, `GraphLength`,
/// `Straightened` and `PairId`, and the field array `PathStatus` with a value per pair: 0, or 1 and
/// a warning if there is no path. Returns the index of the pair of each line.
DGG_CORE_EXPORT std::vector<Offset> WritePaths(
  const TaskContext& context, const PathSearch::Paths& paths, Output& output);
}

#endif
