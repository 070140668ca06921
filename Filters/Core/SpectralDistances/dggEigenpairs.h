// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Eigenfunctions of the Laplacian on a surface.
#ifndef dggEigenpairs_h
#define dggEigenpairs_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggPoissonSolver.h" // for PoissonSolver

#include <cstddef> // for std::size_t
#include <vector>  // for the results

namespace dgg
{
/// The smallest non-zero eigenvalues of L v = lambda M v on one component, with the cotangent
/// Laplacian L and lumped areas M, in increasing order, and their eigenfunctions.
struct Eigenpairs
{
  std::vector<double> Values; ///< unit: 1 / length^2
  std::vector<Id> Vertices;   ///< vertices of the component
  /// Function k at Vertices[i] is Functions[k * Vertices.size() + i]. The functions are
  /// orthonormal: the sum of area times v_i v_j is 1 for i = j, otherwise 0.
  std::vector<double> Functions;
  /// True if it was verified (by the signs of the pivots of L - sigma M, Sylvester's law of
  /// inertia) that no eigenvalue is missing below the last gap in the spectrum. Otherwise members
  /// of clusters may be missing.
  bool IsComplete = false;

  Id GetCount() const { return static_cast<Id>(this->Values.size()); }
  std::size_t GetMemorySize() const
  {
    return (this->Values.size() + this->Functions.size()) * sizeof(double) +
      this->Vertices.size() * sizeof(Id);
  }
};

/// Finds `count` pairs of each component of the solver's system, to a relative accuracy of 1e-8 of
/// the eigenvalues, by Lanczos' method with implicit restarts (Spectra), applied to the inverse. A
/// component may have fewer pairs: eigenvalues beyond 1e13 times the first one are ignored, as
/// occur on meshes with needles; components of thin triangles and vertices without a face have
/// none. With `isWanted`, only its components get pairs. Since pairs of multiple eigenvalues may be
/// missing at first, further searches run in the orthogonal complement of the functions found. The
/// solver must be ready, and its options determine the boundary condition. The memory is about that
/// of 3 `count` functions on the mesh. The result is deterministic, including signs.
DGG_CORE_EXPORT Status FindEigenpairs(const PoissonSolver& solver, Id count,
  const ProgressCallback& progress, std::vector<Eigenpairs>& pairs,
  const std::vector<bool>& isWanted = {});
}

#endif
