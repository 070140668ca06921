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
/// The smallest eigenvalues but 0 of L v = lambda M v on one component, with the cotangent
/// Laplacian L and lumped areas M, in increasing order, and their functions.
struct Eigenpairs
{
  std::vector<double> Values; ///< one over square of length
  std::vector<Id> Vertices;   ///< of the component
  /// Function k at Vertices[i] is Functions[k * Vertices.size() + i]. They are orthonormal: the sum
  /// of area times v_i v_j is 1 for i = j, else 0.
  std::vector<double> Functions;
  /// Whether it was checked (by the signs of the pivots of L - sigma M, Sylvester's law) that none
  /// is missing below the last gap in the spectrum. Else those in clusters may be.
  bool IsComplete = false;

  Id GetCount() const { return static_cast<Id>(this->Values.size()); }
  std::size_t GetMemorySize() const
  {
    return (this->Values.size() + this->Functions.size()) * sizeof(double) +
      this->Vertices.size() * sizeof(Id);
  }
};

/// Finds `count` pairs of each component of the solver's system, fewer where a component has fewer
/// (eigenvalues beyond 1e13 times the first one do not count, as on meshes with needles; components
/// of thin triangles and vertices without a face have none), to a relative accuracy of 1e-8 of the
/// values. With `isWanted`, only its components get pairs. By Lanczos' method with implicit
/// restarts (Spectra), applied to the inverse. Pairs of multiple eigenvalues may be missing at
/// first: further searches run in the orthogonal complement of the functions found. The solver must
/// be ready, and its options decide about the boundary. The memory is about that of 3 `count`
/// functions on the mesh. The same input gives the same result, signs included.
DGG_CORE_EXPORT Status FindEigenpairs(const PoissonSolver& solver, Id count,
  const ProgressCallback& progress, std::vector<Eigenpairs>& pairs,
  const std::vector<bool>& isWanted = {});
}

#endif
