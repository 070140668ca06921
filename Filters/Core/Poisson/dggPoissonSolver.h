// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The Poisson equation on a surface: what Green's functions and their kin share.
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

/// How messages name a point of a surface.
DGG_CORE_EXPORT std::string NameOf(const SurfacePoint& point);

/// What happens at the boundary of the surface.
enum class PoissonBoundary
{
  Neumann,  ///< nothing flows through it
  Dirichlet ///< values are given there; 0 for Green's functions
};

/// How sources are balanced, and means taken, where no values are given.
enum class PoissonWeights
{
  Area,   ///< in proportion to the area around a vertex
  Uniform ///< the same for all vertices (Lipman, Rustamov and Funkhouser, "Biharmonic distance",
          ///< 2010): right for cells of equal area only
};

struct PoissonOptions
{
  PoissonBoundary Boundary = PoissonBoundary::Neumann;
  PoissonWeights Weights = PoissonWeights::Area;
  /// Vertices whose values are given besides those of a Dirichlet boundary, in any order; they may
  /// repeat.
  std::vector<Id> DirichletVertices;
  /// Flip edges until they are Delaunay first: then there are no negative weights, and the maximum
  /// principle holds. For meshes with obtuse triangles.
  bool IntrinsicDelaunay = false;
};

/// -Laplace u = f by linear finite elements (cotangents, lumped areas) on a mesh that must outlive
/// it. The system is factorized once (L D L^T with approximate minimum degree) and kept.
///
/// Any triangle complex will do: edges with more than two faces conduct between all of them,
/// vertices with several fans between these, and orientation plays no part. Where nothing is
/// given in a component, sources are balanced (PoissonWeights), since
/// what flows in must flow out, and the solution has mean 0. Vertices without a face get 0.
/// Elements with cotangents beyond 1e6 are made softer, see MakeCotanLaplacian(); where these are
/// not a few, but carry more than 1 % of the energy of a solution, Factorize() fails; where that is
/// so of a small component only, sources there are refused.
class DGG_CORE_EXPORT PoissonSolver
{
public:
  explicit PoissonSolver(const SurfaceMesh& mesh);
  ~PoissonSolver();
  PoissonSolver(const PoissonSolver&) = delete;
  PoissonSolver& operator=(const PoissonSolver&) = delete;

  /// Asked before the factorization with the bytes that the solver will take, and with those of
  /// them that it does not hold yet. Fails when they are too many.
  using MemoryCheck = std::function<Status(double bytes, double missing)>;

  /// Analyze and factorize the system; what the options do not change is kept. Progress is
  /// reported, and a stop heeded, between the parts of the work.
  Status Prepare(const PoissonOptions& options, const ProgressCallback& progress,
    const MemoryCheck& checkMemory = nullptr);
  /// Bytes that all takes while it is factorized, at most twice what they are.
  double GetEstimatedMemory() const;
  bool IsReady() const;

  /// Replace integrated sources, b_i = integral of f phi_i with the hat function of vertex i, by
  /// the solution; where values are given, replace the given value by itself.
  /// Fails when there are not as many as vertices, or some are not finite, or a thousandth of them
  /// is in components whose triangles are too thin (PoissonSystem::IsThin()).
  Status Solve(std::vector<double>& values) const;
  /// Several right-hand sides, such as the channels of a colour: all or, where one is wrong, none.
  /// More than four are solved for together, eight at a time.
  Status Solve(std::vector<std::vector<double>>& columns) const;
  /// The same for Laplace^2 u = f: with the matrix L of the Laplacian and the areas M it is
  /// L M^-1 L u = b, so that u is the solution for that of -Laplace u = f. With Dirichlet
  /// conditions both are 0 where values are given; with Neumann conditions nothing of either flows
  /// out.
  Status SolveBiLaplace(std::vector<std::vector<double>>& columns) const;
  /// Fails when there are not as many as vertices, or some are not finite.
  Status CheckNumbers(const std::vector<double>& values) const;
  /// What Solve() fails for.
  Status CheckValues(const std::vector<double>& values) const;

  const SurfaceMesh& GetMesh() const;
  const PoissonOptions& GetOptions() const;
  /// Per vertex, a third of the areas of its faces.
  const std::vector<double>& GetAreas() const;
  /// The part of a vertex in means over its component.
  double GetWeight(Id v) const;
  /// Whether the value of a vertex is given.
  bool IsFixed(Id v) const;

  /// Fails when a point is not on the mesh, or a vertex without a face.
  Status CheckPlace(const SurfacePoint& point) const;
  /// Fails when a point is no place for a pole: not on the mesh, without a face, or on a boundary
  /// where values are given, or in a closed component although Dirichlet conditions are asked for,
  /// or in a component whose triangles are too thin.
  Status CheckPole(const SurfacePoint& point) const;

  /// Factorizations done so far, for tests.
  int GetNumberOfFactorizations() const;
  Offset GetNumberOfFactorEntries() const;

  /// For the kernel.
  const PoissonSystem& GetSystem() const { return *this->System; }

private:
  std::unique_ptr<PoissonSystem> System;
};
}

#endif
