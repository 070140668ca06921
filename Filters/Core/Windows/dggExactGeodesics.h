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

/// Which engine propagates. Both give the same distances.
enum class ExactEngine
{
  /// One window at a time in order of distance, Chen-Han split rule and vertex filter: slow, short,
  /// written to be checked by reading (Chen and Han 1990; Xin and Wang, "Improving Chen and Han's
  /// algorithm", 2009).
  Reference,
  /// Lists of windows, triangle by triangle in the order of the vertices (the idea of Qin et al.,
  /// "Fast and exact discrete geodesic computation based on triangle-oriented wavefront
  /// propagation", 2016), each list kept a lower envelope.
  Triangle
};

struct ExactOptions
{
  ExactEngine Engine = ExactEngine::Triangle;
  /// Vertices and targets farther than this are left unreached.
  double MaximumDistance = Infinity;
  /// Points whose distance is wanted besides that of the vertices.
  std::vector<SurfacePoint> Targets;
  /// Stop as soon as the distances of all targets are final; vertices farther than the farthest
  /// target are left unreached. Without targets it has no effect.
  bool StopAtTargets = false;
  /// Whether to fill Windows. Not together with StopAtTargets.
  bool KeepWindows = false;
  /// Most bytes that the engine and the windows that are kept may take at one time, see
  /// ExactResult::PeakMemory; more is an error. Zero: no limit.
  std::size_t MemoryLimit = 0;
  /// Progress and abort; may be empty.
  ProgressCallback Progress;
};

/// How a vertex or a target got its distance: enough to trace the path back (window tracing).
struct Predecessor
{
  /// The half-edge that the last straight piece crosses before it ends in its face (at its apex,
  /// for a vertex), or NoId when it stays in one face or on one mesh edge.
  Id HalfEdge = NoId;
  /// Where the piece starts: a vertex, or ~k for the k-th source (inside a face or an edge);
  /// the vertex itself when it is a source.
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
  std::vector<Predecessor> TargetPredecessors; ///< per target; at vertices those of the vertices

  /// The distance everywhere on the surface, up to the maximum distance; empty unless asked for.
  EdgeWindows Windows;

  std::size_t NumberOfWindows = 0; ///< windows propagated
  /// Estimate of the most bytes held by the engine at one time, windows that are kept included;
  /// mesh and other results apart.
  std::size_t PeakMemory = 0;
};

/// Exact geodesics on one mesh, which must outlive the solver. Run() may be called again and again;
/// one solver per thread. The result does not depend on earlier runs.
class DGG_CORE_EXPORT ExactGeodesics
{
public:
  explicit ExactGeodesics(const SurfaceMesh& mesh);
  ~ExactGeodesics();
  ExactGeodesics(const ExactGeodesics&) = delete;
  ExactGeodesics& operator=(const ExactGeodesics&) = delete;

  /// Distances from the nearest of the sources. Fails when there is no source, or a source or
  /// target does not exist on the mesh or starts with a distance that is not finite, or more memory
  /// is needed than the limit; then `result` is empty.
  Status Run(
    const std::vector<GeodesicSource>& sources, const ExactOptions& options, ExactResult& result);

  /// The same into a result that stays here, valid until the next run: for many runs that each
  /// reach few vertices, as to targets nearby. Such a run takes the time of what it reaches, where
  /// Run() also takes some for each vertex of the mesh.
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
