// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cotangent Laplacian, and the common part of linear systems based on it. Internal: only
/// internal headers include Eigen.
#ifndef dggLaplaceSystem_h
#define dggLaplaceSystem_h

#include "dggIntrinsicTriangulation.h" // for the triangles
#include "dggSparseFactor.h"           // for the order of elimination

#include <Eigen/SparseCore> // for the matrix

#include <array>   // for the cotangents of a face
#include <cstdint> // for flags
#include <vector>  // for arrays

namespace dgg
{
/// Linear finite elements. `Stiffness` is positive semidefinite and without an area factor: for
/// neighbors i, j the entry is -(cot a + cot b) / 2, with the angles opposite to the edge (one on
/// the boundary, more on a non-manifold edge; several edges between i and j add up), and rows sum
/// to 0. Thus (L f)_i approximates the integral of -Laplace f over the cell of i; boundaries have
/// natural (Neumann) conditions. `Mass` is lumped: a third of the areas of the faces around a
/// vertex. Vertices without a face have rows of zeros (with an explicit diagonal entry) and no
/// mass.
///
/// The element matrix of a face with a cotangent beyond `largestCotangent` is scaled down to that
/// limit as a whole, so that it remains semidefinite. Next to cotangents of 1e13, which occur in
/// needles of almost no area, the other entries would be lost to rounding.
struct CotanLaplacian
{
  Eigen::SparseMatrix<double> Stiffness;
  Eigen::VectorXd Mass;
};

/// Returns the cotangents of the three corners of a face, scaled down to the largest one allowed.
std::array<double, 3> GetCotangents(
  const IntrinsicTriangulation& triangulation, Id face, double largestCotangent = Infinity);

CotanLaplacian MakeCotanLaplacian(
  const IntrinsicTriangulation& triangulation, double largestCotangent = Infinity);

/// The cotangent Laplacian of a mesh, which must outlive the object, its components, and an
/// elimination order. The heat method and Poisson equations factorize matrices derived from it.
class LaplaceSystem
{
public:
  Id GetComponent(Id v) const { return this->Components[v]; }
  Id GetNumberOfComponents() const { return this->NumberOfComponents; }
  bool IsOnBoundary(Id v) const { return this->OnBoundary[v] != 0; }

protected:
  explicit LaplaceSystem(const SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Builds the system on the triangles of the mesh, or on those after edge flips. Reports progress
  /// up to 0.9.
  Status Build(bool isDelaunay, double largestCotangent, const ProgressCallback& progress);

  const SurfaceMesh& Mesh;
  Id NumberOfComponents = 0;
  IntrinsicTriangulation Triangulation;
  std::vector<Id> Components;           // per vertex
  std::vector<std::uint8_t> OnBoundary; // per vertex
  std::vector<double> Areas;            // per vertex, a third of the areas of its faces
  Eigen::SparseMatrix<double> Stiffness;
  EliminationOrder Order;
  std::vector<Id> Pinned; // per component, the vertex eliminated last
};
}

#endif
