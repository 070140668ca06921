// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Searches in a graph by the updates of a filter. Internal.
#ifndef dggGraphSession_h
#define dggGraphSession_h

#include "dggBandPath.h"       // for BandPathShortener
#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggGraphBuilder.h"   // for GraphBuilder
#include "dggPathFinder.h"     // for PathFinder
#include "dggPreparedGraph.h"  // for the graph
#include "dggTaskContext.h"    // for TaskContext

#include <cstdint>  // for the build number
#include <memory>   // for objects made on demand
#include <optional> // for the search
#include <vector>   // for seeds

namespace dgg
{
/// A graph and the data that searches reuse between updates: landmarks, links of points that are
/// not vertices, and the builder of links.
class DGG_CORE_EXPORT GraphSession
{
public:
  using Points = std::vector<SurfacePoint>;

  /// Starts an update. Releases the data of another surface, but keeps a graph of an equal surface.
  void Start(const PreparedSurface& surface);

  ///@{
  /// Sets or releases the graph to search. The graph must belong to the surface.
  void Use(PreparedGraph::Pointer graph);
  void Release();
  ///@}
  bool HasGraph() const { return this->Graph != nullptr; }
  /// Returns the summary of the graph; all values are zero without a graph.
  const GraphSummary& GetSummary() const;

  /// Builds a graph of the surface.
  Status Build(const TaskContext& context, GraphOptions options, GeodesicGraph& graph);

  /// Returns a callback for the progress that remains after the calls so far.
  ProgressCallback GetRemainingProgress(const TaskContext& context) const;

  const GraphSearch& GetSearch() const { return *this->Search; }
  /// Returns the result buffer of searches. The buffer is kept after local searches, so that the
  /// next search resets only reached vertices.
  SearchResult& GetResult() { return this->Result; }

  ///@{
  /// Sets or returns the accuracy of links: the accuracy of the graph, or `accuracy` for a graph
  /// without one.
  void SetLinkAccuracy(double accuracy) { this->DefaultAccuracy = accuracy; }
  double GetLinkAccuracy() const;
  ///@}
  ///@{
  /// Returns the search radius at which every point closer than `maximum` is reached. `offset` is
  /// the smallest initial distance, `accuracy` that of links.
  double WidenLimit(double maximum, const std::vector<GeodesicSource>& sources) const;
  static double WidenLimit(double maximum, double offset, double accuracy);
  ///@}

  /// Announces searches for `count` pairs of points. After many pairs, computes distances from
  /// landmarks, which speed up all later searches.
  Status PrepareForPairs(const TaskContext& context, std::size_t count);

  /// Makes the seeds of a search from sources: one seed for each vertex, and one for each link of
  /// the other sources. Links are kept while surface, accuracy and points are the same.
  Status MakeSeeds(const TaskContext& context, const std::vector<GeodesicSource>& sources,
    std::vector<GraphSeed>& seeds);
  /// Prepares the builder that links points that are not vertices. All users of the surface share
  /// the builder; clouds have none. Fails if the builder would exceed the memory limit. A builder
  /// that is not needed now is kept for later updates unless it exceeds the memory limit.
  Status PrepareBuilder(const TaskContext& context, bool isNeeded = true);
  const GraphBuilder& GetBuilder() const { return *this->Builder; }
  /// Finds the links of a point, and its distance from each of `aims` along a straight path outside
  /// the graph; infinity without such a path. Needs PrepareBuilder() for points that are not
  /// vertices.
  Status Link(const SurfacePoint& place, const Points& aims, std::vector<GraphLink>& links,
    std::vector<double>& direct) const;

  /// Returns the finder of paths in the graph, with links if a builder exists. The memory of the
  /// finder is proportional to the size of the mesh. The finder is kept while graph and builder are
  /// the same.
  const PathFinder& GetPathFinder();
  /// Returns the shortener of paths on a cloud, which refers to the graph.
  BandPathShortener MakeShortener() const;

  /// Returns an estimate of the bytes of the graph, shared or not, and of the buffers of searches.
  std::size_t GetMemorySize() const;

private:
  /// Links of points, with the accuracy and the points for which they are valid.
  struct LinkStore
  {
    double Accuracy = 0.0;
    Points Places;
    std::vector<std::vector<GraphLink>> Links; // per point
  };

  void ReleaseBuilder();
  Status LinkPlaces(const TaskContext& context, const Points& places);
  ProgressCallback TakeProgress(const TaskContext& context, double share);

  std::uint64_t Surface = 0; // build number
  PreparedGraph::Pointer Graph;
  std::optional<GraphSearch> Search; // searches Graph, with landmarks after many pairs
  std::size_t NumberOfPairs = 0;     // announced for Graph
  SearchResult Result;
  std::shared_ptr<const GraphBuilder> Builder;
  std::size_t BuilderSize = 0;        // bytes
  std::unique_ptr<PathFinder> Finder; // in Search, with Builder
  LinkStore Store;
  double DefaultAccuracy = 0.0;
  double Done = 0.0; // progress of this update
};
}

#endif
