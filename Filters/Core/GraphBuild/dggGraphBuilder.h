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
/// Smallest and largest accuracy of a graph.
constexpr double MinimumAccuracy = 1e-6;
constexpr double MaximumAccuracy = 0.5;

struct GraphOptions
{
  GraphConstruction Construction = GraphConstruction::Guaranteed;
  /// Relative, in [MinimumAccuracy, MaximumAccuracy]: with the guaranteed construction the bound of
  /// the error of every distance. Not used by the SaddleVertexGraph.
  double Accuracy = 0.01;
  /// Of the SaddleVertexGraph: how many nearest vertices each vertex looks at. At least 1.
  Id NumberOfNeighbors = 30;
  ParallelFor Parallel;      ///< may be empty
  ProgressCallback Progress; ///< may be empty; called from the thread that called Build()
  int NumberOfThreads = 1;   ///< that Parallel may use, for the estimate of memory
};

/// What a graph will take, predicted from the rows of some vertices.
struct GraphEstimate
{
  double Edges = 0.0;  ///< directed
  double Memory = 0.0; ///< bytes of the graph
  double Peak = 0.0;   ///< most bytes while it is built, at most twice too many
};

/// What building a graph took.
struct GraphStatistics
{
  std::size_t Windows = 0;  ///< faces crossed by windows
  std::size_t OutEdges = 0; ///< directed edges before both directions were united
};

/// Windows that one source may send out before it is given up: among non-manifold edges windows can
/// multiply without end. Sources at the smallest accuracy stay well below.
constexpr std::size_t DefaultWindowLimit = std::size_t{ 1 } << 21;

/// An edge between a surface point and a vertex of the graph: a geodesic without a bend.
struct GraphLink
{
  Id Vertex = NoId;
  double Length = 0.0;
  /// Polar angle at the vertex, pointing back to the point.
  double ArrivalAngle = 0.0;
  /// Direction at the point, towards the vertex: angle in the frame of the first half-edge of the
  /// point's face, as WalkStraight() takes it. The other faces of a point on an edge are unfolded
  /// into that plane.
  double DepartureAngle = 0.0;
};

/// Builds graphs of one mesh, which must outlive the builder.
///
/// For every vertex, windows are sent over the surface, face by face, unfolded into one
/// plane. A window is bounded by the rays through two vertices, its relays. It ends at an edge
/// behind which every point is covered: reached through a relay with enough progress. Vertices in
/// the window that are not covered become edges of the graph.
class DGG_CORE_EXPORT GraphBuilder
{
public:
  /// Prepares tables of the mesh. With a vertex that takes more windows than `windowLimit`
  /// no graph can be built. Nor can one where non-manifold edges or triangles without area multiply
  /// the work beyond some twenty times that on a clean mesh of the size.
  explicit GraphBuilder(const SurfaceMesh& mesh, std::size_t windowLimit = DefaultWindowLimit);
  ~GraphBuilder();
  GraphBuilder(const GraphBuilder&) = delete;
  GraphBuilder& operator=(const GraphBuilder&) = delete;

  /// Fails with a message when an option is out of range.
  static Status Check(const GraphOptions& options);

  /// Predict what Build() will take. Cheap: builds the rows of some vertices. Fails where Build()
  /// fails, or where the sample takes several times its share of the work that is allowed.
  Status Estimate(const GraphOptions& options, GraphEstimate& estimate) const;

  /// Build the graph: the same, bit by bit, for any Parallel. `graph` is empty on failure. The
  /// signature is left to the caller. May throw std::bad_alloc.
  Status Build(
    const GraphOptions& options, GeodesicGraph& graph, GraphStatistics* statistics = nullptr) const;

  /// The edges that a surface point would have as a vertex of the graph, sorted by vertex: with
  /// them, distances from and to the point keep the promise of the (guaranteed) graph. `targets`
  /// are other points; `direct[i]` becomes the length of the straight way to targets[i], Infinity
  /// where there is none among the windows. A point at a vertex has a single link, of length 0.
  /// Both are empty on failure. `work` grows by what it took if windows multiplied, in comparisons
  /// of one window with another. May be called from several threads at once.
  Status Link(const SurfacePoint& point, double accuracy, const std::vector<SurfacePoint>& targets,
    std::vector<GraphLink>& links, std::vector<double>& direct, std::size_t* work = nullptr) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
