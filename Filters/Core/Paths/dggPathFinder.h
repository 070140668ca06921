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
#include <memory>  // for the workspaces

namespace dgg
{
class PathTracer;
template <typename Workspace>
class WorkspacePool;

struct PathOptions
{
  /// Whether to shorten the path to a locally shortest geodesic.
  bool Straighten = true;
  /// Behind every bump there are several locally shortest paths. With Straighten, the shortest path
  /// among those is found that have detours from the first one of up to this fraction of its
  /// length: the exact solver runs in the corridor of faces around it. 0: the first one.
  double Detour = 1e-4;
  /// Accuracy of the links of points that are not vertices. 0: that of the graph, which it needs to
  /// have (a SaddleVertexGraph has none).
  double LinkAccuracy = 0.0;
};

/// A path and how it was found.
struct FoundPath
{
  SurfacePath Path; ///< empty when the points are not connected
  /// Length of the path in the graph, before it was straightened: within the accuracy of the exact
  /// distance. Infinity when the points are not connected.
  double GraphLength = Infinity;
  bool IsStraightened = false; ///< whether it is a locally shortest geodesic
  /// Edges of the graph whose direction, stored as a float, did not lead to their head, so that
  /// they had to be found anew. None expected.
  Id NumberOfFallbacks = 0;
};

/// Finds paths in a graph. What it is made from must outlive it. Paths may be found in several
/// threads at once.
class DGG_CORE_EXPORT PathFinder
{
public:
  /// `positions`, x y z per vertex, guide the search; they may be null. `builder` may be null when
  /// all points are vertices.
  PathFinder(const SurfaceMesh& mesh, const GraphSearch& search, const GraphBuilder* builder,
    const double* positions);
  ~PathFinder();
  PathFinder(const PathFinder&) = delete;
  PathFinder& operator=(const PathFinder&) = delete;

  /// A path from one point to another, traced on the surface. Its length is at most that in the
  /// graph. Fails when a point does not exist; points that are not connected are no failure.
  Status Find(const SurfacePoint& from, const SurfacePoint& to, const PathOptions& options,
    FoundPath& found) const;

  /// Bytes that are kept for the next paths, as much for each thread that has found one. May be
  /// called when the mesh is gone.
  std::size_t GetMemorySize() const;

private:
  struct Workspace;
  struct Ends;

  Status FindBetween(const SurfacePoint& from, const SurfacePoint& to, const PathOptions& options,
    FoundPath& found) const;
  Status Link(const SurfacePoint& from, const SurfacePoint& to, double accuracy, Ends& ends) const;
  Status TraceGraphEdges(PathTracer& tracer, const SurfacePoint& from, const SurfacePoint& to,
    const Ends& ends, const GraphPath& path) const;
  void Finish(Workspace& workspace, const PathOptions& options, FoundPath& found) const;

  const SurfaceMesh& Mesh;
  const GraphSearch& Search;
  const GraphBuilder* Builder;
  const double* Positions;
  const Status Usable; // whether the mesh is
  std::unique_ptr<WorkspacePool<Workspace>> Workspaces;
};
}

#endif
