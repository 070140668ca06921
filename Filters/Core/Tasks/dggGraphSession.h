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

  /// Starts an update. Releases what belongs to another surface, but keeps the graph if it is that
  /// of an equal surface.
  void Start(const PreparedSurface& surface);

  ///@{
  /// Sets or releases the graph to search. It must be that of the surface.
  void Use(PreparedGraph::Pointer graph);
  void Release();
  ///@}
  bool HasGraph() const { return this->Graph != nullptr; }
  /// Numbers of the graph; all zero if there is none.
  const GraphSummary& GetSummary() const;

  /// Builds a graph of the surface.
  Status Build(const TaskContext& context, GraphOptions options, GeodesicGraph& graph);

  /// Returns a callback for the progress that remains after the calls so far.
  ProgressCallback GetRemainingProgress(const TaskContext& context) const;

  const GraphSearch& GetSearch() const { return *this->Search; }
  /// Kept after local searches, so that the next search resets only reached vertices.
  SearchResult& GetResult() { return this->Result; }

  ///@{
  /// Accuracy of links: that of the graph. Graphs without an accuracy use `accuracy`.
  void SetLinkAccuracy(double accuracy) { this->DefaultAccuracy = accuracy; }
  double GetLinkAccuracy() const;
  ///@}
  /// Returns the search radius at which every point closer than `maximum` is reached.
  double WidenLimit(double maximum, const std::vector<GeodesicSource>& sources) const;

  /// Announces searches for `count` pairs of points. After many of them, distances from landmarks
  /// are computed, which speed up all later searches.
  Status PrepareForPairs(const TaskContext& context, std::size_t count);

  /// Makes the seeds of a search from sources: one for each vertex, and one for each link of the
  /// others. Links are kept while surface, accuracy and points are the same.
  Status MakeSeeds(const TaskContext& context, const std::vector<GeodesicSource>& sources,
    std::vector<GraphSeed>& seeds);
  /// Prepares the builder that links points that are not vertices. All users of the surface share
  /// it. Fails if it would exceed the memory limit; clouds have none. A builder that is not needed
  /// now is kept for later updates unless it exceeds the memory limit.
  Status PrepareBuilder(const TaskContext& context, bool isNeeded = true);
  const GraphBuilder& GetBuilder() const { return *this->Builder; }
  /// Finds the links of a point, and its distance from each of `aims` along a straight path outside
  /// the graph; infinity if there is none. Needs PrepareBuilder() for points that are not vertices.
  Status Link(const SurfacePoint& place, const Points& aims, std::vector<GraphLink>& links,
    std::vector<double>& direct) const;

  /// Returns the finder of paths in the graph, with links if there is a builder. Its memory is
  /// proportional to the size of the mesh; it is kept while graph and builder are the same.
  const PathFinder& GetPathFinder();
  /// Returns the shortener of paths on a cloud. It refers to the graph.
  BandPathShortener MakeShortener() const;

  /// Returns an estimate of the bytes of the graph, shared or not, and of what searches keep.
  std::size_t GetMemorySize() const;

private:
  /// Links of points, and what they depend on.
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
  std::optional<GraphSearch> Search; // that of Graph, with landmarks after many pairs
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
