// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cotangent Laplacian. Internal: the only headers that name Eigen are internal ones.
#ifndef dggCotanLaplacian_h
#define dggCotanLaplacian_h

#include "dggIntrinsicTriangulation.h"

#include <Eigen/SparseCore> // for the matrix

#include <array> // for the cotangents of a face

namespace dgg
{
/// Linear finite elements. `Stiffness` is positive semidefinite and without an area factor: for
/// neighbours i, j the entry is -(cot a + cot b) / 2, with the angles that face the edge (one on
/// the boundary, more on a non-manifold edge; several edges between i and j add up), and rows sum
/// to 0. So (L f)_i approximates the integral of -Laplace f over the cell of i; boundaries have
/// natural (Neumann) conditions. `Mass` is lumped: a third of the areas of the faces around a
/// vertex. Vertices without a face have rows of zeros (a diagonal entry is there) and no mass.
///
/// The matrices of faces with a cotangent beyond `largestCotangent` are scaled down to it as a
/// whole, so that they stay semidefinite. Among cotangents of 1e13, as needles with next to no area
/// have them, the others would be lost to rounding.
struct CotanLaplacian
{
  Eigen::SparseMatrix<double> Stiffness;
  Eigen::VectorXd Mass;
};

/// The cotangents of the three corners of a face, scaled down to the largest one allowed.
std::array<double, 3> GetCotangents(
  const IntrinsicTriangulation& triangulation, Id face, double largestCotangent = Infinity);

CotanLaplacian MakeCotanLaplacian(
  const IntrinsicTriangulation& triangulation, double largestCotangent = Infinity);
/// From the triangles of the mesh as they are. Orientation and manifoldness do not matter.
CotanLaplacian MakeCotanLaplacian(const SurfaceMesh& mesh);
}

#endif
