// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact polyhedral geodesic distances from several sources by window propagation.
#ifndef dggExactGeodesics_h
#define dggExactGeodesics_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggEdgeWindows.h"    // for EdgeWindows
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggSurfacePoint.h"   // for SurfacePoint

#include <cstddef> // for std::size_t
#include <memory>  // for the engine
#include <vector>  // for the results

namespace dgg
{
class WindowPropagation;

/// Propagation engine. Both engines give the same distances.
enum class ExactEngine
{
  /// One window at a time in order of distance, with the Chen-Han split rule and the vertex filter.
  /// Slow but short, so that it can be verified by reading (Chen and Han 1990; Xin and Wang,
  /// "Improving Chen and Han's algorithm", 2009).
  Reference,
  /// Lists of windows, triangle by triangle in the order of the vertices (after Qin et al., "Fast
  /// and exact discrete geodesic computation based on triangle-oriented wavefront propagation",
  /// 2016), where each list is maintained as a lower envelope.
  Triangle
};

struct ExactOptions
{
  ExactEngine Engine = ExactEngine::Triangle;
  /// Vertices and targets farther than this are left unreached.
  double MaximumDistance = Infinity;
  /// Surface points whose distance is computed in addition to the vertices.
  std::vector<SurfacePoint> Targets;
  /// Stop as soon as the distances of all targets are final; vertices beyond the farthest target
  /// remain unreached. No effect without targets.
  bool StopAtTargets = false;
  /// If true, fill ExactResult::Windows. Cannot be combined with StopAtTargets.
  bool KeepWindows = false;
  /// Maximum memory of the engine and the stored windows in bytes (see ExactResult::PeakMemory);
  /// exceeding it is an error. Zero means no limit.
  std::size_t MemoryLimit = 0;
  /// Progress and abort; may be empty.
  ProgressCallback Progress;
};

/// The last segment of the shortest path to a vertex or target: enough to trace the path back
/// through windows.
struct Predecessor
{
  /// The half-edge that the last straight segment crosses before it ends in its face (for a vertex,
  /// at the apex); NoId if the segment stays in one face or on one mesh edge.
  Id HalfEdge = NoId;
  /// Start of the segment: a vertex, or ~k for the k-th source (inside a face or on an edge). A
  /// source vertex is its own root.
  Id Root = NoId;
  /// Image of the root in the frame of HalfEdge (y < 0).
  double ImageX = 0.0;
  double ImageY = 0.0;
};

struct ExactResult
{
  std::vector<double> Distances; ///< per vertex; Infinity where unreached
  std::vector<Id> NearestSource; ///< per vertex, index into the sources; NoId where unreached
  std::vector<Predecessor> Predecessors;       ///< per vertex
  std::vector<double> TargetDistances;         ///< per target; Infinity where unreached
  std::vector<Id> TargetNearestSource;         ///< per target
  std::vector<Predecessor> TargetPredecessors; ///< per target; at a vertex, that of the vertex

  /// The distance at every surface point up to the maximum distance; empty unless KeepWindows is
  /// set.
  EdgeWindows Windows;

  std::size_t NumberOfWindows = 0; ///< windows propagated
  /// Estimated peak memory of the engine in bytes, including stored windows but neither the mesh
  /// nor other results.
  std::size_t PeakMemory = 0;
};

/// Computes exact geodesics on one mesh, which must outlive the solver. Run() may be called
/// repeatedly and its result does not depend on earlier runs. Use one solver per thread.
class DGG_CORE_EXPORT ExactGeodesics
{
public:
  explicit ExactGeodesics(const SurfaceMesh& mesh);
  ~ExactGeodesics();
  ExactGeodesics(const ExactGeodesics&) = delete;
  ExactGeodesics& operator=(const ExactGeodesics&) = delete;

  /// Computes distances from the nearest source. Fails if there is no source, a source or target
  /// does not exist on the mesh, an initial distance is not finite, or the memory limit is
  /// exceeded; then `result` is empty.
  Status Run(
    const std::vector<GeodesicSource>& sources, const ExactOptions& options, ExactResult& result);

  /// Like Run(), but stores the result in the solver, where it is valid until the next run. Meant
  /// for many runs that each reach few vertices (such as to nearby targets): the cost is
  /// proportional to the number of vertices reached, whereas Run() also has a cost per mesh vertex.
  Status RunKept(const std::vector<GeodesicSource>& sources, const ExactOptions& options);
  const ExactResult& GetKept() const { return this->Kept; }

private:
  WindowPropagation& GetEngine(ExactEngine kind);

  const SurfaceMesh& Mesh;
  std::unique_ptr<WindowPropagation> Engine;
  ExactEngine EngineKind = ExactEngine::Triangle;
  ExactResult Kept;
};
}

#endif
