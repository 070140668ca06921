// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shortest paths in a discrete geodesic graph.
#ifndef dggGraphSearch_h
#define dggGraphSearch_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggGeodesicGraph.h"  // for GraphView
#include "dggParallel.h"       // for ParallelFor
#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggVirtualSources.h" // for VirtualSources

#include <cstddef>    // for std::size_t
#include <cstdint>    // for std::uint8_t
#include <functional> // for FieldConsumer
#include <memory>     // for the internals
#include <vector>     // for the results

namespace dgg
{
class Landmarks;

/// Where a search starts: a vertex and the distance that it starts with. A surface point is a seed
/// per link (GraphBuilder::Link()).
struct GraphSeed
{
  Id Vertex = NoId;
  double Distance = 0.0;        ///< label that the vertex starts with
  double InitialDistance = 0.0; ///< part of it that is the offset of the source
  Id Source = 0;                ///< reported as nearest source
  /// For the seed of a surface point: polar angle at the vertex, pointing back to the point.
  /// Negative when the source is the vertex itself.
  double ArrivalAngle = -1.0;
};

/// Fails with a message when a vertex does not exist.
DGG_CORE_EXPORT Status CheckVertex(Id vertex, Id numberOfVertices);
/// Fails with a message when there is no seed, or one does not exist or starts with a distance that
/// is not finite.
DGG_CORE_EXPORT Status CheckSeeds(const std::vector<GraphSeed>& seeds, Id numberOfVertices);

enum class SearchMethod : std::uint8_t
{
  Dijkstra,        ///< label setting, the reference
  LabelCorrecting, ///< in buckets of distance, over all edges
  Certified        ///< first over fans of edges straight ahead, then certified over all edges;
                   ///< short rows, for which this does not pay, are relaxed whole
};

struct SearchOptions
{
  SearchMethod Method = SearchMethod::Certified;
  /// Vertices farther than this are left unreached.
  double MaximumDistance = Infinity;
  /// Whether to fill Corrected.
  bool Correct = false;
  ProgressCallback Progress; ///< may be empty
};

struct SearchResult
{
  std::vector<double> Distances; ///< per vertex, the length of a real path; Infinity if unreached
  std::vector<Id> Seeds;         ///< per vertex, index of the seed that it is reached from, or NoId
  /// Per vertex, the edge through which it is reached (from its tail); -1 for seeds and unreached
  /// vertices.
  std::vector<Offset> Edges;
  std::vector<Id> Tails; ///< per vertex, tail of that edge, or NoId
  /// Per vertex, a better estimate within the accuracy of the exact distance: neither an upper
  /// bound nor a metric. Empty unless asked for.
  std::vector<double> Corrected;
  /// The virtual source behind the estimate of each vertex. Empty unless asked for.
  VirtualSources Virtual;

  /// The vertices that are reached, each once, in no particular order.
  std::vector<Id> Reached;
  /// Returns true if visiting these alone is cheaper than visiting all vertices.
  DGG_CORE_EXPORT bool IsLocal() const;

  std::size_t NumberOfPops = 0;        ///< vertices taken from the queue
  std::size_t NumberOfRelaxations = 0; ///< edges relaxed or certified
  std::size_t NumberOfLabels = 0;      ///< entries of Distances written, initial values included
};

/// A shortest path in a graph, from start to end.
struct GraphPath
{
  double Length = Infinity; ///< with the distances of the seeds at both ends
  Id FromSeed = NoId;       ///< index of the seed at the start
  Id ToSeed = NoId;         ///< index of the seed at the end
  /// From that of the one seed to that of the other one; empty when there is no path.
  std::vector<Id> Vertices;
  std::vector<Offset> Edges; ///< Edges[i] leads from Vertices[i] to Vertices[i + 1]
};

/// Options of a search from many sources
struct ManyOptions
{
  /// Vertices farther than this from a source are left unreached.
  double MaximumDistance = Infinity;
  /// Vertices whose distances are asked for; empty: all. Vertices that are farther from a source
  /// than all of these may be left unreached.
  std::vector<Id> Targets;
  /// If true, the consumer receives the estimates of SearchResult::Corrected, otherwise labels.
  bool Correct = false;
};

/// Receives the distances of all vertices from source number `source`, Infinity where unreached,
/// and the vertices that are reached, each once, in no particular order. The arrays must not be
/// used after the call. Called in any order, by several threads
/// simultaneously.
using FieldConsumer =
  std::function<void(std::size_t source, const double* distances, const std::vector<Id>& reached)>;

/// Searches in one graph, whose arrays must outlive it, as must the mesh. Searches may run in
/// several threads at once. Copies share what has been made for the graph; each uses landmarks only
/// when it has prepared them itself, so that its answers do not depend on what others have done.
class DGG_CORE_EXPORT GraphSearch
{
public:
  /// `mesh` is that of the graph, or null for a cloud: then there are no fans and no correction.
  GraphSearch(const GraphView& graph, const SurfaceMesh* mesh);

  const GraphView& GetGraph() const;

  /// Distances from the nearest of the seeds: the same, up to rounding, by every method. Fails when
  /// there is no seed, or one does not exist or starts with a distance that is not finite; then
  /// `result` is empty. If `result` is that of an earlier call, from which any array but `Reached`
  /// may have been moved, the cost is proportional to the number of vertices within the radii of
  /// both searches.
  Status Run(
    const std::vector<GraphSeed>& seeds, const SearchOptions& options, SearchResult& result) const;

  /// A shortest path between two sets of seeds, those of two points, by A*. Empty when they are
  /// not connected. `positions`, x y z per vertex, may be null; no edge may be shorter than the
  /// straight line between its ends. They show the way, as do landmarks.
  Status Between(const std::vector<GraphSeed>& from, const std::vector<GraphSeed>& to,
    const double* positions, GraphPath& path) const;

  /// Find distances of all vertices from some landmarks, which Between() uses from then on. Takes
  /// as long as some dozens of searches, and 68 bytes per vertex, but nothing where a copy has them
  /// already. To be called before searches, not during one. On abort nothing has changed.
  Status PrepareLandmarks(const ParallelFor& parallel, const ProgressCallback& progress);
  bool HasLandmarks() const;

  /// Distances from each of many sources, a set of seeds, on its own; `consume` receives them.
  /// Where most of the surface is searched, sources close together are searched together. Hundreds
  /// of sources then take half the time of single searches, or less. The cost of other searches is
  /// proportional to the number of vertices within the radius, or nearer than the farthest target.
  /// Adds the number of labels (see SearchResult) to `numberOfLabels` unless that is null.
  Status Many(const std::vector<std::vector<GraphSeed>>& sources, const ManyOptions& options,
    const ParallelFor& parallel, const ProgressCallback& progress, const FieldConsumer& consume,
    std::size_t* numberOfLabels = nullptr) const;

  /// Bytes held besides the graph, about.
  std::size_t GetMemorySize() const;

private:
  class Implementation;
  std::shared_ptr<const Implementation> Internals;
  std::shared_ptr<const Landmarks> Marks; // null until they are prepared
};
}

#endif
