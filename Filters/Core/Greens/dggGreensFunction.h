// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Green's functions of the Laplacian on a surface.
#ifndef dggGreensFunction_h
#define dggGreensFunction_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggPoissonSolver.h" // for PoissonSolver
#include "dggSurfacePoint.h"  // for poles and targets

#include <cstddef> // for std::size_t
#include <memory>  // for what is kept from run to run
#include <vector>  // for the results

namespace dgg
{
struct GreensWorkspace;

/// How the Green's function of a point is found.
enum class GreensMethod
{
  /// g = s(d) + r: the logarithm s of the geodesic distance, cut off at a radius, carries the pole
  /// exactly; finite elements solve for r, which is smooth. Second order for a radius that is held.
  /// The usual radius is not more than 48 mean edges, which some 30 000 vertices of a sphere have:
  /// beyond that errors fall more slowly. On the unit sphere with 10 242, 40 962 and 163 842
  /// vertices the relative L2 error within 0.2 of the pole was 4.9e-5, 1.7e-5 and 7.0e-6 (4.6e-6
  /// with a radius of 0.85), the largest error 3.5e-5, 1.3e-5 and 9.8e-6. First order next to a
  /// pole that is not on a boundary but within a few edges of it, since r has the mirror image of
  /// the pole.
  SingularitySubtraction,
  /// Interpolated, corrected around the pole: of the values there that reproduce the geodesic
  /// distances from points nearby in Green's identity, those next to the interpolated ones. No
  /// better than these: the relative L2 error over the vertices that are changed, on unit spheres
  /// with 642, 2562 and 10 242 vertices and in the mean over 1020 poles in faces of each,
  /// is 1.01 to 1.03 times as large: 1.5 times in the middle of faces (all coordinates above 0.2),
  /// 0.9 times between there and the corners. For comparison.
  Localized,
  /// The columns of the corners, weighted with barycentric coordinates: the finite element solution
  /// with a point load. First order near the pole.
  Interpolated,
  /// The column of the corner with the largest barycentric coordinate of those without a given
  /// value (Lipman, Rustamov and
  /// Funkhouser, "Biharmonic distance", 2010).
  Vertex
};

/// Of which operator.
enum class GreensOrder
{
  Laplace,
  /// Laplace^2 q = delta - 1 / area, so q(x, y) is the integral of g(x, z) g(z, y), an area;
  /// without given values its mean is 0. Of the bi-Laplacian L M^-1 L in numbers, M the lumped
  /// areas: two substitutions. It is smooth but for d^2 log(d) / (4 Theta) at the pole, Theta the
  /// angle around it, finite, and positive there whatever the sign of g. Interpolated is symmetric,
  /// and second order but for a logarithm at the pole. SingularitySubtraction takes out what is not
  /// smooth: second order everywhere.
  BiLaplace
};

/// Which sign Green's functions have next to the pole.
enum class GreensSign
{
  Positive, ///< -Laplace g = delta - 1 / area
  Negative  ///< Laplace g = delta - 1 / area
};

/// What SingularitySubtraction gives as value at the pole itself, where the function is infinite.
enum class GreensPole
{
  CellAverage, ///< the mean over a disk as large as the cell of the vertex, or as a third of the
               ///< face where the target is inside of one
  Infinite
};

/// What became of a query besides its result.
enum class GreensRemark
{
  None,
  /// The disk that the logarithm could be taken out of is smaller than four mean edges, or the
  /// usual one smaller than two longest sides of triangles (in the mean over the area), or all
  /// corners of the pole's face have given values, which makes finite elements 0: Interpolated was
  /// used. Refine the mesh around the pole.
  TooCoarse,
  /// Within ten mean edges of the pole, or the Radius that was asked for, shortest ways meet from
  /// different sides, as behind a spike or a sharp corner: the regular part has kinks there. Errors
  /// are still a fraction of those of Interpolated.
  NearRidge,
  /// The triangle of the flipped mesh that the pole lies in was not found: Interpolated was used.
  NoTriangle,
  /// Localized needs all values around the pole to be free, distances there that make sense, and
  /// not more than a few hundred neighbours: Interpolated was used.
  NotLocalized
};

struct GreensQuery
{
  GreensMethod Method = GreensMethod::SingularitySubtraction;
  GreensOrder Order = GreensOrder::Laplace; ///< Sign and Pole play no part in the other one
  GreensSign Sign = GreensSign::Positive;
  GreensPole Pole = GreensPole::CellAverage;
  /// Where s ends. 0: 0.28 times the square root of the component's area (up to 0.35 on coarse
  /// meshes), or 48 mean edges; less where shortest ways meet from different sides before, or are
  /// so many that they would cost more than the solve.
  double Radius = 0.0;
  /// Points whose values are wanted besides those of the vertices.
  std::vector<SurfacePoint> Targets;
  bool WantIntegrals = false;
  ProgressCallback Progress; ///< may be empty
};

struct GreensResult
{
  std::vector<double> Values;       ///< per vertex; 0 in other components
  std::vector<double> TargetValues; ///< per target
  /// Per vertex, the integral of g phi_i with the hat function of the vertex, lumped, if asked for.
  /// sum Integrals[i] f_i + (mean of u) is the solution of -Laplace u = f, or Laplace^2 u = f, at
  /// the pole.
  std::vector<double> Integrals;
  GreensMethod Method = GreensMethod::Vertex; ///< the one used
  GreensRemark Remark = GreensRemark::None;
  double Radius = 0.0; ///< where s ends; 0 without s
};

/// Green's functions on the mesh of a solver, which must be ready and outlive it. With Neumann
/// conditions, or without boundary, g sums to 0 (weighted) in the component of its pole; in others
/// it is 0. With Dirichlet conditions it is 0 on the boundary.
///
/// The formulae: L g = e_j - w for vertex j, with positive semidefinite L and weights w that sum to
/// 1 per component, and w^T g = 0. Then G is symmetric, L G = I - w 1^T, and
/// f_j = w^T f + sum_i G_ji (L f)_i for every f.
class DGG_CORE_EXPORT GreensFunction
{
public:
  explicit GreensFunction(const PoissonSolver& solver);
  ~GreensFunction();
  GreensFunction(const GreensFunction&) = delete;
  GreensFunction& operator=(const GreensFunction&) = delete;

  /// The Green's function of one point. Fails where PoissonSolver::CheckPole() does. May be called
  /// by several threads at once.
  Status Run(const SurfacePoint& pole, const GreensQuery& query, GreensResult& result) const;
  /// Those of several points: `results[k]` belongs to pole k. Blocks of eight from the first one on
  /// are solved for together, in about half the time. May be called by several threads at once, for
  /// blocks of their own; progress is reported by the thread that calls.
  Status Run(const std::vector<SurfacePoint>& poles, const GreensQuery& query,
    std::vector<GreensResult>& results) const;
  static constexpr Id PolesInBlock = 8;
  /// Bytes that one thread takes for a block, results included, at most: for each vertex, and for
  /// each target.
  static constexpr double BytesPerVertex = 560.0;
  static constexpr double BytesPerTarget = 128.0;

private:
  class Workspaces;

  Status RunBlock(const std::vector<SurfacePoint>& poles, std::size_t first, std::size_t end,
    const GreensQuery& query, const ProgressCallback& progress,
    std::vector<GreensResult>& results) const;

  const PoissonSolver& Solver;
  std::unique_ptr<Workspaces> Pool;
};
}

#endif
