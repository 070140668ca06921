// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What linear systems on a mesh have in common. Internal.
#ifndef dggLaplaceSystem_h
#define dggLaplaceSystem_h

#include "dggIntrinsicTriangulation.h" // for the triangles
#include "dggSparseFactor.h"           // for the order of elimination

#include <Eigen/SparseCore> // for the matrix

#include <cstdint> // for flags
#include <vector>  // for arrays

namespace dgg
{
/// Whether `progress` wants the work to go on.
inline bool Goes(const ProgressCallback& progress, double fraction)
{
  return !progress || progress(fraction);
}

/// The cotangent Laplacian of a mesh, which must outlive it, the components, and the order of
/// elimination. The heat method and Poisson equations factorize matrices made of it.
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

  /// On the triangles of the mesh, or on those after flips of edges. Progress to 0.9.
  Status Build(bool isDelaunay, double largestCotangent, const ProgressCallback& progress);

  const SurfaceMesh& Mesh;
  Id NumberOfComponents = 0;
  IntrinsicTriangulation Triangulation;
  std::vector<Id> Components;           // per vertex
  std::vector<std::uint8_t> OnBoundary; // per vertex
  std::vector<double> Areas;            // per vertex, a third of those of its faces
  Eigen::SparseMatrix<double> Stiffness;
  EliminationOrder Order;
  std::vector<Id> Pinned; // per component, the vertex that is eliminated last
};
}

#endif
