// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The Poisson equation on a mesh by other libraries. Their headers stay inside the source files.
#ifndef PeerPoisson_h
#define PeerPoisson_h

#include "MeshArrays.h" // for MeshArrays

#include <memory> // for those who make one
#include <vector> // for sources and solutions

/// For a connected mesh without vertices that no face uses. One value is held at 0.
class PeerPoisson
{
public:
  virtual ~PeerPoisson() = default;

  /// The matrix from the mesh, and its factorization, all anew. False when the library says so.
  virtual bool Prepare() = 0;
  /// A solution for integrated sources that sum to 0, up to a constant. After Prepare().
  virtual bool Solve(const std::vector<double>& sources, std::vector<double>& solution) = 0;
};

#ifdef DGG_WITH_CHOLMOD
/// CHOLMOD, left to choose its method and order, with our matrix.
std::unique_ptr<PeerPoisson> MakePeerCholmod(const MeshArrays& mesh);
#endif

#ifdef DGG_WITH_LIBIGL
/// libigl's cotangent matrix and its min_quad_with_fixed, which uses Eigen's SimplicialLLT. With
/// the power 2, the matrix is that of the bi-Laplacian (igl::harmonic).
std::unique_ptr<PeerPoisson> MakePeerLibigl(const MeshArrays& mesh, int power);
#endif

#endif
