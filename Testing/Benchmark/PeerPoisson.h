// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Solvers of the Poisson equation on a mesh by other libraries, whose headers are included in the
/// source files only.
#ifndef PeerPoisson_h
#define PeerPoisson_h

#include "MeshArrays.h" // for MeshArrays

#include <memory> // for std::unique_ptr
#include <vector> // for sources and solutions

/// Solver for a connected mesh in which each vertex has a face. One value is fixed to 0.
class PeerPoisson
{
public:
  virtual ~PeerPoisson() = default;

  /// Computes the matrix from the mesh, and its factorization. Returns false if the library reports
  /// a failure.
  virtual bool Prepare() = 0;
  /// Computes a solution, up to a constant, for integrated sources that sum to 0. Call Prepare()
  /// first.
  virtual bool Solve(const std::vector<double>& sources, std::vector<double>& solution) = 0;
};

#ifdef DGG_WITH_CHOLMOD
/// Returns CHOLMOD with its default method and ordering, applied to our matrix.
std::unique_ptr<PeerPoisson> MakePeerCholmod(const MeshArrays& mesh);
#endif

#ifdef DGG_WITH_LIBIGL
/// Returns libigl's cotangent matrix and its min_quad_with_fixed, which uses Eigen's SimplicialLLT.
/// With power 2, the matrix is that of the bi-Laplacian (igl::harmonic).
std::unique_ptr<PeerPoisson> MakePeerLibigl(const MeshArrays& mesh, int power);
#endif

#endif
