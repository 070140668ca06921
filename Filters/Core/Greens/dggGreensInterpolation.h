// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Green's functions of many points from those of vertices.
#ifndef dggGreensInterpolation_h
#define dggGreensInterpolation_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggGreensFunction.h" // for queries and results

#include <cstddef> // for std::size_t
#include <memory>  // for what is kept

namespace dgg
{
/// With g = s(d) + r as in GreensMethod::SingularitySubtraction, the regular part r of a point is
/// that of the corners of its face, weighted with barycentric coordinates:
///
///     g(x, y) = s(d(x, y)) + sum_k w_k r_k(y).
///
/// Only columns of vertices are ever solved for, when they are first asked for, and kept as floats;
/// any two points then cost one distance. Errors are several times those of a solve per point, and
/// a tenth or less of those of interpolated Green's functions. All poles of a component have the
/// same radius: ridges of the distance do not count.
class DGG_CORE_EXPORT GreensInterpolation
{
public:
  /// The solver must be ready and outlive this. Columns beyond the limit of memory push out those
  /// that have not been used for longest; those of one face are kept in any case. All are found
  /// again after the solver has been prepared with other options.
  explicit GreensInterpolation(
    const PoissonSolver& solver, std::size_t memoryLimit = std::size_t(1) << 28);
  ~GreensInterpolation();
  GreensInterpolation(const GreensInterpolation&) = delete;
  GreensInterpolation& operator=(const GreensInterpolation&) = delete;

  /// From the next run on.
  void SetMemoryLimit(std::size_t bytes) { this->MemoryLimit = bytes; }

  /// The Green's function of one point. The query's method plays no part, and integrals are those
  /// of the interpolation. Where the mesh is too coarse, or given values are corners of the face,
  /// the result is that of GreensFunction. To be called by one thread at a time.
  Status Run(const SurfacePoint& pole, const GreensQuery& query, GreensResult& result);

  /// Columns solved for so far, for tests.
  Id GetNumberOfColumns() const;
  /// Bytes held.
  std::size_t GetMemorySize() const;

private:
  class Cache;

  const PoissonSolver& Solver;
  std::size_t MemoryLimit;
  std::unique_ptr<Cache> Columns;
};
}

#endif
