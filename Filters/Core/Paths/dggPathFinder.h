// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shortest paths between any two points of a surface.
#ifndef dggPathFinder_h
#define dggPathFinder_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggGraphBuilder.h" // for links of points that are not vertices
#include "dggGraphSearch.h"  // for the graph
#include "dggSurfacePath.h"  // for SurfacePath

#include <cstddef> // for std::size_t
#include <cstdint> // for flags
#include <memory>  // for the workspaces
#include <vector>  // for routes

namespace dgg
{
class PathTracer;
template <typename Workspace>
class WorkspacePool;

struct PathOptions
{
  /// If true, shorten the path to a locally shortest geodesic.
  bool Straighten = true;
  /// Behind every bump there are several locally shortest paths. With Straighten, the exact solver
  /// runs in the corridor of faces around the first path, and finds the shortest path among those
  /// whose detour from the first path is at most this fraction of its length. 0 keeps the first
  /// path.
  double Detour = 1e-4;
  /// Accuracy of the links of points that are not vertices. 0 means the accuracy of the graph,
  /// which must have one (a SaddleVertexGraph has none).
  double LinkAccuracy = 0.0;
};

/// A path and how it was found.
struct FoundPath
{
  SurfacePath Path; ///< empty if the points are not connected
  /// Length of the graph path before straightening: within the accuracy of the exact distance.
  /// Infinity if the points are not connected.
  double GraphLength = Infinity;
  bool IsStraightened = false; ///< true if locally shortest
  /// Number of graph edges whose direction, stored as a float, did not lead to their head, so that
  /// the geodesic had to be computed again. Expected to be 0.
  Id NumberOfFallbacks = 0;
  /// True if the path depends on the rim of a submesh, so that it may differ from that on the
  /// surface.
  bool MeetsRim = false;
};

/// A path in a graph, to be traced on the surface.
struct GraphRoute
{
  double Length = Infinity; ///< GraphPath::Length
  std::vector<Id> Vertices; ///< GraphPath::Vertices
  ///@{
  /// Per edge between these vertices, its direction (GraphView::Angles) and length.
  std::vector<double> Angles;
  std::vector<double> Lengths;
  ///@}
  GraphLink Links[2];       ///< to the first and the last vertex, of ends that are not vertices
  double Direct = Infinity; ///< length of the straight line between the ends
};

/// Finds paths in a graph. All constructor arguments must outlive the finder. Several threads may
/// find paths simultaneously.
class DGG_CORE_EXPORT PathFinder
{
public:
  /// `positions`, x y z per vertex, guide the search; they may be null. `builder` may be null if
  /// all points are vertices.
  PathFinder(const SurfaceMesh& mesh, const GraphSearch& search, const GraphBuilder* builder,
    const double* positions);
  /// Makes a finder that traces on a submesh; Find() must not be called. `isRim` flags the vertices
  /// some of whose faces are not in the submesh.
  PathFinder(const SurfaceMesh& mesh, const std::uint8_t* isRim);
  ~PathFinder();
  PathFinder(const PathFinder&) = delete;
  PathFinder& operator=(const PathFinder&) = delete;

  /// Finds a path from one point to another, traced on the surface, at most as long as the
  /// graph path. Fails if a point does not exist; points that are not connected are not a
  /// failure.
  Status Find(const SurfacePoint& from, const SurfacePoint& to, const PathOptions& options,
    FoundPath& found) const;

  /// Traces a path that was found in a graph, which Find() does after a search.
  Status Trace(const SurfacePoint& from, const SurfacePoint& to, const GraphRoute& route,
    const PathOptions& options, FoundPath& found) const;

  /// Returns the size in bytes of the buffers that are reused for later paths, one set per thread
  /// that has found a path. May be called after the mesh has been destroyed.
  std::size_t GetMemorySize() const;

private:
  struct Workspace;
  struct Ends;

  Status FindBetween(const SurfacePoint& from, const SurfacePoint& to, const PathOptions& options,
    FoundPath& found) const;
  Status Link(const SurfacePoint& from, const SurfacePoint& to, double accuracy, Ends& ends) const;
  Status TraceGraphEdges(PathTracer& tracer, const SurfacePoint& from, const SurfacePoint& to,
    const GraphRoute& route) const;
  void Finish(Workspace& workspace, const PathOptions& options, FoundPath& found) const;

  const SurfaceMesh& Mesh;
  const GraphSearch* Search = nullptr;
  const GraphBuilder* Builder = nullptr;
  const double* Positions = nullptr;
  const std::uint8_t* IsRim = nullptr;
  const Status Usable; // error if the mesh cannot be used
  std::unique_ptr<WorkspacePool<Workspace>> Workspaces;
};
}

#endif
