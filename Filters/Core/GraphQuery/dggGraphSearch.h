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
struct VertexAngle;

/// Start of a search: a vertex and its initial distance. A surface point has one seed per link
/// (GraphBuilder::Link()).
struct GraphSeed
{
  Id Vertex = NoId;
  double Distance = 0.0;        ///< initial label of the vertex
  double InitialDistance = 0.0; ///< offset of the source, included in Distance
  Id Source = 0;                ///< reported as nearest source
  /// For a seed of a surface point: polar angle at the vertex, pointing back to the point. Negative
  /// if the source is the vertex itself.
  double ArrivalAngle = -1.0;
};

/// Fails if a vertex does not exist.
DGG_CORE_EXPORT Status CheckVertex(Id vertex, Id numberOfVertices);
/// Fails if there is no seed, or a seed does not exist or has an initial distance that is not
/// finite.
DGG_CORE_EXPORT Status CheckSeeds(const std::vector<GraphSeed>& seeds, Id numberOfVertices);

enum class SearchMethod : std::uint8_t
{
  Dijkstra,        ///< label setting, the reference
  LabelCorrecting, ///< in buckets of distance, over all edges
  Certified        ///< first over fans of edges straight ahead, then certified over all edges;
                   ///< short rows are relaxed completely
};

struct SearchOptions
{
  SearchMethod Method = SearchMethod::Certified;
  /// Vertices farther than this distance are left unreached.
  double MaximumDistance = Infinity;
  /// If true, SearchResult::Corrected and SearchResult::Virtual are filled.
  bool Correct = false;
  ProgressCallback Progress; ///< may be empty
};

struct SearchResult
{
  std::vector<double> Distances; ///< per vertex, length of an actual path; Infinity if unreached
  std::vector<Id> Seeds;         ///< per vertex, index of its seed, or NoId
  /// Per vertex, the edge through which the vertex is reached, in the row of its tail; -1 for seeds
  /// and unreached vertices.
  std::vector<Offset> Edges;
  std::vector<Id> Tails; ///< per vertex, tail of that edge, or NoId
  /// Per vertex, an improved estimate of the distance, within the accuracy of the exact distance;
  /// neither an upper bound nor a metric. Empty unless requested.
  std::vector<double> Corrected;
  /// Virtual source of each vertex, from which the estimate follows. Empty unless requested.
  VirtualSources Virtual;

  /// Reached vertices, each once, in no particular order.
  std::vector<Id> Reached;
  /// Returns true if visiting the reached vertices is cheaper than visiting all vertices.
  DGG_CORE_EXPORT bool IsLocal() const;

  std::size_t NumberOfPops = 0;        ///< vertices taken from the queue
  std::size_t NumberOfRelaxations = 0; ///< edges relaxed or certified
  std::size_t NumberOfLabels = 0;      ///< entries of Distances written, initial values included
};

/// A shortest path in a graph, from start to end.
struct GraphPath
{
  double Length = Infinity; ///< including the distances of the seeds at both ends
  Id FromSeed = NoId;       ///< index of the seed at the start
  Id ToSeed = NoId;         ///< index of the seed at the end
  /// Vertices from the start seed to the end seed; empty if no path exists.
  std::vector<Id> Vertices;
  std::vector<Offset> Edges; ///< Edges[i] leads from Vertices[i] to Vertices[i + 1]
};

/// Options of a search from many sources.
struct ManyOptions
{
  /// Vertices farther than this distance from a source are left unreached.
  double MaximumDistance = Infinity;
  /// Vertices whose distances are requested; empty means all. Vertices that are farther from a
  /// source than all targets may be left unreached.
  std::vector<Id> Targets;
  /// If true, the consumer receives the estimates of SearchResult::Corrected, otherwise labels.
  bool Correct = false;
};

/// Groups of sources for Many().
struct ManyPlan
{
  std::vector<std::vector<std::size_t>> Groups; ///< indices of sources that are searched together
  std::size_t Reach = 0;                        ///< estimated number of vertices per search
};

/// Receives the distances of all vertices from source `source` (Infinity if unreached), and the
/// reached vertices, each once, in no particular order. The arrays must not be used after the call.
/// Called in any order, by several threads simultaneously.
using FieldConsumer =
  std::function<void(std::size_t source, const double* distances, const std::vector<Id>& reached)>;

/// Searches shortest paths in one graph. The graph arrays and the mesh must outlive the search.
/// Several threads may search simultaneously. Copies share precomputed data of the graph. A copy
/// uses landmarks only if prepared through this copy, so that its answers do not depend on other
/// copies.
class DGG_CORE_EXPORT GraphSearch
{
public:
  /// Prepares searches. `mesh` is the mesh of the graph, or null for a cloud; without a mesh, fans
  /// and correction are not available.
  GraphSearch(const GraphView& graph, const SurfaceMesh* mesh);
  /// Prepares searches with measurements of the mesh, see MeasureVertexAngles(). Results are those
  /// of a search with the mesh. PlanMany(), Between() and PrepareLandmarks() need the mesh. No
  /// angles means that there is no mesh.
  GraphSearch(const GraphView& graph, std::vector<VertexAngle> angles, double meanEdgeLength);

  const GraphView& GetGraph() const;

  /// Computes distances from the nearest seed. All methods give the same distances and the same
  /// tree: among the shortest paths to a vertex, a seed comes first, then the smallest tail. Fails
  /// with an empty `result` if there is no seed, or if a seed does not exist or has an initial
  /// distance that is not finite. If `result` is from an earlier call, from which any array but
  /// `Reached` may have been moved, the cost is proportional to the number of vertices within the
  /// radii of both searches.
  Status Run(
    const std::vector<GraphSeed>& seeds, const SearchOptions& options, SearchResult& result) const;

  /// Finds a shortest path by A* between two sets of seeds, the seeds of two points. The path is
  /// empty if the sets are not connected. `positions`, x y z per vertex, may be null; no edge may
  /// be shorter than the straight line between its ends. Positions and landmarks provide the lower
  /// bounds of A*.
  Status Between(const std::vector<GraphSeed>& from, const std::vector<GraphSeed>& to,
    const double* positions, GraphPath& path) const;

  /// Computes the distances of all vertices from some landmarks, which Between() uses from then on.
  /// Costs as much as several dozen searches and 68 bytes per vertex, but nothing if a copy already
  /// has landmarks. Must not be called during a search. Nothing is changed on abort.
  Status PrepareLandmarks(const ParallelFor& parallel, const ProgressCallback& progress);
  bool HasLandmarks() const;

  /// Computes distances from each of many sources (each a set of seeds) separately; `consume`
  /// receives the distances. If most of the surface is searched, sources close together are
  /// searched together; hundreds of sources then take at most half the time of single searches. The
  /// cost of other searches is proportional to the number of vertices within the radius, or nearer
  /// than the farthest target. Adds the number of labels (see SearchResult) to `numberOfLabels`
  /// unless null.
  Status Many(const std::vector<std::vector<GraphSeed>>& sources, const ManyOptions& options,
    const ParallelFor& parallel, const ProgressCallback& progress, const FieldConsumer& consume,
    std::size_t* numberOfLabels = nullptr) const;

  ///@{
  /// The two steps of Many(). The groups of a plan may be searched in any order and by different
  /// objects for the same graph. Sources that are in no group of the plan are ignored.
  Status PlanMany(const std::vector<std::vector<GraphSeed>>& sources, const ManyOptions& options,
    ManyPlan& plan) const;
  Status Many(const std::vector<std::vector<GraphSeed>>& sources, const ManyOptions& options,
    const ManyPlan& plan, const ParallelFor& parallel, const ProgressCallback& progress,
    const FieldConsumer& consume, std::size_t* numberOfLabels = nullptr) const;
  ///@}

  /// Returns the approximate memory in bytes, without the graph.
  std::size_t GetMemorySize() const;
  /// Returns the approximate peak memory in bytes of a search and of Many() with this number of
  /// threads, without the graph and the results.
  static double EstimateMany(Id numberOfVertices, int numberOfThreads);

private:
  class Implementation;
  std::shared_ptr<const Implementation> Internals;
  std::shared_ptr<const Landmarks> Marks; // null until they are prepared
};
}

#endif
