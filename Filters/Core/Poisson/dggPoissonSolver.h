// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Solver of the Poisson equation on a surface, shared by Green's functions and related methods.
#ifndef dggPoissonSolver_h
#define dggPoissonSolver_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h"  // for SurfaceMesh
#include "dggSurfacePoint.h" // for SurfacePoint

#include <functional> // for the check of memory
#include <memory>     // for the system
#include <string>     // for names
#include <vector>     // for sources and solutions

namespace dgg
{
class PoissonSystem;

/// Returns the name of a surface point for messages.
DGG_CORE_EXPORT std::string NameOf(const SurfacePoint& point);

/// Boundary condition.
enum class PoissonBoundary
{
  Neumann,  ///< no flux through the boundary
  Dirichlet ///< values are given; 0 for Green's functions
};

/// Weights of vertices for balancing sources and for means, in components without given values.
enum class PoissonWeights
{
  Area,   ///< proportional to the area around a vertex
  Uniform ///< equal for all vertices (Lipman, Rustamov and Funkhouser, "Biharmonic distance",
          ///< 2010): correct only for cells of equal area
};

struct PoissonOptions
{
  PoissonBoundary Boundary = PoissonBoundary::Neumann;
  PoissonWeights Weights = PoissonWeights::Area;
  /// Vertices with given values, in addition to a Dirichlet boundary, in any order, possibly
  /// repeated.
  std::vector<Id> DirichletVertices;
  /// If true, edges are first flipped until they are Delaunay: then no weight is negative, and the
  /// maximum principle holds. For meshes with obtuse triangles.
  bool IntrinsicDelaunay = false;
};

/// Solves -Laplace u = f by linear finite elements (cotangents, lumped areas) on a mesh that must
/// outlive the object. The system is factorized once (L D L^T with approximate minimum degree) and
/// reused.
///
/// Any triangle complex is accepted: edges with more than two faces connect all of them, vertices
/// connect all their fans, and orientation is irrelevant. In components without given values,
/// sources are balanced (PoissonWeights), because total inflow and outflow must agree, and the
/// solution has mean 0. Vertices without a face get 0. Elements with cotangents beyond 1e6 are
/// softened, see CotanLaplacian. If softened elements carry more than 1 % of the energy of a
/// solution, Factorize() fails; if this concerns a small component only, sources in that component
/// are rejected.
class DGG_CORE_EXPORT PoissonSolver
{
public:
  explicit PoissonSolver(const SurfaceMesh& mesh);
  ~PoissonSolver();
  PoissonSolver(const PoissonSolver&) = delete;
  PoissonSolver& operator=(const PoissonSolver&) = delete;

  /// Called before the factorization with the bytes that the solver will need in total, and the
  /// part of them that is not yet allocated. Fails if memory is insufficient.
  using MemoryCheck = std::function<Status(double bytes, double missing)>;

  /// Analyzes and factorizes the system; unaffected data is reused. Progress is reported, and
  /// aborts are handled, between the steps.
  Status Prepare(const PoissonOptions& options, const ProgressCallback& progress,
    const MemoryCheck& checkMemory = nullptr);
  /// Returns the estimated peak memory of the factorization in bytes, at most twice the actual
  /// size.
  double GetEstimatedMemory() const;
  bool IsReady() const;

  /// Replaces integrated sources, b_i = integral of f phi_i with the hat function of vertex i, by
  /// the solution; given values are returned unchanged. Fails if the size differs from the number
  /// of vertices, a value is not finite, or a thousandth of the sources is in components whose
  /// triangles are too thin (PoissonSystem::IsThin()).
  Status Solve(std::vector<double>& values) const;
  /// Solves for several right-hand sides, such as color channels: all of them or, if one is
  /// invalid, none. More than four are solved together, eight at a time.
  Status Solve(std::vector<std::vector<double>>& columns) const;
  /// Like Solve(), for Laplace^2 u = f: with the matrix L of the Laplacian and the areas M, solves
  /// L M^-1 L u = b, i.e. two Poisson equations in sequence. With Dirichlet conditions both u and
  /// Laplace u are 0 at given values; with Neumann conditions both have no flux through the
  /// boundary.
  Status SolveBiLaplace(std::vector<std::vector<double>>& columns) const;
  /// Fails if the size differs from the number of vertices, or a value is not finite.
  Status CheckNumbers(const std::vector<double>& values) const;
  /// Fails if Solve() would fail for these values.
  Status CheckValues(const std::vector<double>& values) const;

  const SurfaceMesh& GetMesh() const;
  const PoissonOptions& GetOptions() const;
  /// Returns, per vertex, a third of the areas of its faces.
  const std::vector<double>& GetAreas() const;
  /// Returns the weight of a vertex in means over its component.
  double GetWeight(Id v) const;
  /// Returns true if the value of a vertex is given.
  bool IsFixed(Id v) const;

  /// Fails if a point is not on the mesh, or is a vertex without a face.
  Status CheckPlace(const SurfacePoint& point) const;
  /// Fails if a point cannot be a pole: not on the mesh, without a face, on a boundary with given
  /// values, in a closed component although Dirichlet conditions are requested, or in a component
  /// whose triangles are too thin.
  Status CheckPole(const SurfacePoint& point) const;

  /// Returns the number of factorizations so far, for tests.
  int GetNumberOfFactorizations() const;
  Offset GetNumberOfFactorEntries() const;

  /// Returns the factorized system; only used by other classes of the kernel.
  const PoissonSystem& GetSystem() const { return *this->System; }

private:
  std::unique_ptr<PoissonSystem> System;
};
}

#endif
