// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shortest paths by exact distances.
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
/// have reached all targets, and the way of each is followed back. One finder per thread.
class DGG_CORE_EXPORT ExactPathFinder
{
public:
  explicit ExactPathFinder(const SurfaceMesh& mesh);
  ~ExactPathFinder();
  ExactPathFinder(const ExactPathFinder&) = delete;
  ExactPathFinder& operator=(const ExactPathFinder&) = delete;

  /// Paths from one point to others, in the order of `to`; empty ones to points that are not
  /// connected with it, or farther than `maximumDistance`. Fails when a point does not exist, when
  /// a face of the mesh names a vertex twice, and, which happens only among piles of faces without
  /// area, when a path cannot be traced back.
  Status Find(const SurfacePoint& from, const std::vector<SurfacePoint>& to,
    const ProgressCallback& progress, std::vector<SurfacePath>& paths,
    double maximumDistance = Infinity);

  /// Windows that the last call propagated; none when the solver failed.
  std::size_t GetNumberOfWindows() const { return this->NumberOfWindows; }

  /// Bytes that are kept for the next calls: as many as the call with most of them has taken, and
  /// the distances of the last one.
  std::size_t GetMemorySize() const;

private:
  const SurfaceMesh& Mesh;
  const Status Fitness; // of the mesh
  std::unique_ptr<ExactGeodesics> Solver;
  std::size_t NumberOfWindows = 0;
  std::size_t MemorySize = 0;
};
}

#endif
