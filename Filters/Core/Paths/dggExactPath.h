// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact shortest paths.
#ifndef dggExactPath_h
#define dggExactPath_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggExactGeodesics.h" // for the solver
#include "dggSurfacePath.h"    // for SurfacePath

#include <cstddef> // for std::size_t
#include <memory>  // for the solver
#include <vector>  // for paths

namespace dgg
{
/// Finds exact shortest paths by window tracing: windows are propagated from the source until they
/// have reached all targets, and the path to each target is traced back. Use one finder per thread.
class DGG_CORE_EXPORT ExactPathFinder
{
public:
  explicit ExactPathFinder(const SurfaceMesh& mesh);
  ~ExactPathFinder();
  ExactPathFinder(const ExactPathFinder&) = delete;
  ExactPathFinder& operator=(const ExactPathFinder&) = delete;

  /// Finds paths from one point to others, in the order of `to`; a path is empty if its point is
  /// not connected with `from` or farther than `maximumDistance`. Fails if a point does not exist,
  /// a face of the mesh contains a vertex twice, or a path cannot be traced back, which happens
  /// only among clusters of degenerate faces.
  Status Find(const SurfacePoint& from, const std::vector<SurfacePoint>& to,
    const ProgressCallback& progress, std::vector<SurfacePath>& paths,
    double maximumDistance = Infinity);

  /// Returns the number of windows that the last call propagated; 0 if the solver failed.
  std::size_t GetNumberOfWindows() const { return this->NumberOfWindows; }

  /// Returns the size in bytes of the buffers that are reused by later calls: the maximum over all
  /// calls, plus the distances of the last call.
  std::size_t GetMemorySize() const;

private:
  const SurfaceMesh& Mesh;
  const Status Fitness; // CheckCorners() of the mesh
  std::unique_ptr<ExactGeodesics> Solver;
  std::size_t NumberOfWindows = 0;
  std::size_t MemorySize = 0;
};
}

#endif
