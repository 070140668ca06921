// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Green's functions of many points, interpolated from those of vertices.
#ifndef dggGreensInterpolation_h
#define dggGreensInterpolation_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggGreensFunction.h" // for queries and results

#include <cstddef> // for std::size_t
#include <memory>  // for the cache

namespace dgg
{
/// With g = s(d) + r as in GreensMethod::SingularitySubtraction, the regular part r of a point is
/// interpolated from the corners of its face with barycentric coordinates:
///
///     g(x, y) = s(d(x, y)) + sum_k w_k r_k(y).
///
/// Only columns of vertices are solved, on first use, and stored as floats; any further pair of
/// points costs one distance. Errors are several times those of a solve per point, but at most a
/// tenth of those of interpolated Green's functions. All poles of a component have the same radius:
/// ridges of the distance are ignored.
class DGG_CORE_EXPORT GreensInterpolation
{
public:
  /// Creates an empty cache of columns for a solver, which must be ready and outlive the object. If
  /// the memory limit is exceeded, least recently used columns are discarded; the columns of the
  /// current face are always kept. All columns are recomputed after the solver has been prepared
  /// with other options.
  explicit GreensInterpolation(
    const PoissonSolver& solver, std::size_t memoryLimit = std::size_t(1) << 28);
  ~GreensInterpolation();
  GreensInterpolation(const GreensInterpolation&) = delete;
  GreensInterpolation& operator=(const GreensInterpolation&) = delete;

  /// Sets the limit that is used from the next run on.
  void SetMemoryLimit(std::size_t bytes) { this->MemoryLimit = bytes; }

  /// Computes the Green's function of one point. The method of the query is ignored, and integrals
  /// are those of the interpolation. If the mesh is too coarse, or corners of the face have given
  /// values, the result is that of GreensFunction. Not thread-safe.
  Status Run(const SurfacePoint& pole, const GreensQuery& query, GreensResult& result);

  /// Returns the number of columns solved so far, for tests.
  Id GetNumberOfColumns() const;
  /// Returns the memory in bytes.
  std::size_t GetMemorySize() const;

private:
  class Cache;

  const PoissonSolver& Solver;
  std::size_t MemoryLimit;
  std::unique_ptr<Cache> Columns;
};
}

#endif
