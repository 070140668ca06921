// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Builds the discrete geodesic graph of a triangle mesh.
#ifndef dggGraphBuilder_h
#define dggGraphBuilder_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggGeodesicGraph.h" // for GeodesicGraph
#include "dggParallel.h"      // for ParallelFor
#include "dggSurfaceMesh.h"   // for SurfaceMesh
#include "dggSurfacePoint.h"  // for SurfacePoint

#include <cstddef> // for std::size_t
#include <memory>  // for the internals
#include <vector>  // for links

namespace dgg
{
/// Smallest and largest accuracy of a graph (relative error).
constexpr double MinimumAccuracy = 1e-6;
constexpr double MaximumAccuracy = 0.5;

struct GraphOptions
{
  GraphConstruction Construction = GraphConstruction::Guaranteed;
  /// Bound of the relative error of every distance with the guaranteed construction, in
  /// [MinimumAccuracy, MaximumAccuracy]. Not used by the SaddleVertexGraph.
  double Accuracy = 0.01;
  /// K of the SaddleVertexGraph: number of nearest vertices considered per vertex. At least 1.
  Id NumberOfNeighbors = 30;
  ParallelFor Parallel;      ///< may be empty
  ProgressCallback Progress; ///< may be empty; called from the thread that called Build()
  int NumberOfThreads = 1;   ///< threads that Parallel may use, to estimate memory
};

/// Returns options that build a graph like this one of a mesh.
DGG_CORE_EXPORT GraphOptions MakeOptions(const GraphInfo& graph);

/// Returns true if the options build a graph like this one.
DGG_CORE_EXPORT bool IsBuiltWith(const GraphInfo& graph, const GraphOptions& options);

struct GraphRegion;

/// Predicted size of a graph, extrapolated from the rows of some vertices.
struct GraphEstimate
{
  double Edges = 0.0;  ///< directed
  double Memory = 0.0; ///< bytes of the graph
  double Peak = 0.0;   ///< peak bytes during construction; overestimated at most twofold
};

/// Work statistics of a construction.
struct GraphStatistics
{
  std::size_t Windows = 0;  ///< number of faces crossed by windows
  std::size_t OutEdges = 0; ///< directed edges before both directions were united
  std::size_t Work = 0;     ///< in units of one comparison between two windows
};

/// Maximum number of windows of one source before construction fails. At non-manifold edges windows
/// may multiply without end. Sources at the smallest accuracy stay well below this limit.
constexpr std::size_t DefaultWindowLimit = std::size_t{ 1 } << 21;

/// An edge between a surface point and a graph vertex: a geodesic that bends at no vertex.
struct GraphLink
{
  Id Vertex = NoId;
  double Length = 0.0;
  /// Polar angle at the vertex, pointing back to the point.
  double ArrivalAngle = 0.0;
  /// Direction at the point, towards the vertex: angle in radians in the frame of the first
  /// half-edge of the point's face, as WalkStraight() expects. For a point on an edge, the other
  /// faces of the edge are unfolded into the plane of this face.
  double DepartureAngle = 0.0;
};

/// Builds graphs of one mesh, which must outlive the builder.
///
/// For every vertex, windows are propagated over the surface, face by face, unfolded into one
/// plane. A window is bounded by the rays through two vertices, its relays. A window ends at an
/// edge behind which every point is covered, that is, reached through a relay with enough progress.
/// Vertices in the window that are not covered become graph edges.
class DGG_CORE_EXPORT GraphBuilder
{
public:
  /// Prepares tables of the mesh. Building fails if a vertex needs more windows than `windowLimit`.
  /// Building also fails if non-manifold edges or degenerate triangles multiply the work beyond
  /// about twenty times the work on a clean mesh of the same size.
  explicit GraphBuilder(const SurfaceMesh& mesh, std::size_t windowLimit = DefaultWindowLimit);
  /// Prepares Link() for points of a region.
  GraphBuilder(const SurfaceMesh& mesh, const GraphRegion& region);
  ~GraphBuilder();
  GraphBuilder(const GraphBuilder&) = delete;
  GraphBuilder& operator=(const GraphBuilder&) = delete;

  /// Fails if an option is out of range.
  static Status Check(const GraphOptions& options);

  /// Predicts the size of the graph. The prediction is cheap because only the rows of some vertices
  /// are built. Fails if Build() would fail, or if the sample takes several times its share of the
  /// allowed work.
  Status Estimate(const GraphOptions& options, GraphEstimate& estimate) const;

  /// Builds the graph. The result is bitwise identical for any Parallel. `graph` is empty on
  /// failure. The caller has to set the signature. May throw std::bad_alloc.
  Status Build(
    const GraphOptions& options, GeodesicGraph& graph, GraphStatistics* statistics = nullptr) const;

  /// Computes the edges that a surface point would have as a vertex of the graph, sorted by vertex.
  /// With these links, distances from and to the point satisfy the bound of the (guaranteed) graph.
  /// `targets` are further points; `direct[i]` becomes the length of the straight line to
  /// targets[i], or Infinity if no window contains the target. A point at a vertex has a single
  /// link, of length 0. Both outputs are empty on failure. If windows multiplied, `work` is
  /// increased by the number of window comparisons. `meetsRim` becomes true if windows meet the rim
  /// of a region, so that the links are not complete. May be called by several threads
  /// simultaneously.
  Status Link(const SurfacePoint& point, double accuracy, const std::vector<SurfacePoint>& targets,
    std::vector<GraphLink>& links, std::vector<double>& direct, std::size_t* work = nullptr,
    bool* meetsRim = nullptr) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
