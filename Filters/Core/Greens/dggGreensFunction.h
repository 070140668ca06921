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
#include <memory>  // for reused buffers
#include <vector>  // for the results

namespace dgg
{

/// Method by which the Green's function of a point is computed.
enum class GreensMethod
{
  /// Singularity subtraction, g = s(d) + r: the logarithm s of the geodesic distance, cut off at a
  /// radius, represents the pole exactly; finite elements solve for r, which is smooth. Second
  /// order for a fixed radius. The default radius is at most 48 mean edges, which is reached at
  /// about 30 000 vertices on a sphere; on finer meshes errors decrease more slowly. On the unit
  /// sphere with 10 242, 40 962 and 163 842 vertices the relative L2 error within 0.2 of the pole
  /// was 4.9e-5, 1.7e-5 and 7.0e-6 (4.6e-6 with a radius of 0.85), the largest error 3.5e-5, 1.3e-5
  /// and 9.8e-6. First order next to an interior pole within a few edges of a boundary, since r
  /// contains the mirror image of the pole.
  SingularitySubtraction,
  /// Interpolated, with a correction around the pole: of the values that reproduce the geodesic
  /// distances from nearby points in Green's identity, the correction chooses the values closest to
  /// the interpolated ones. The method serves for comparison and is not better than Interpolated.
  /// The relative L2 error over the modified vertices, on unit spheres with 642, 2562 and 10 242
  /// vertices and averaged over 1020 poles in faces of each sphere, is 1.01 to 1.03 times as large
  /// as that of Interpolated: 1.5 times in the middle of faces (all coordinates above 0.2), 0.9
  /// times between the middle and the corners.
  Localized,
  /// Weighted sum of the columns of the corners, with barycentric coordinates as weights: the
  /// finite element solution with a point load. First order near the pole.
  Interpolated,
  /// Column of the corner with the largest barycentric coordinate among the corners without a given
  /// value (Lipman, Rustamov and Funkhouser, "Biharmonic distance", 2010).
  Vertex
};

/// Operator of the Green's function.
enum class GreensOrder
{
  Laplace,
  /// Laplace^2 q = delta - 1 / area, so q(x, y) is the integral of g(x, z) g(z, y), an area;
  /// without given values its mean is 0. Discretely, the bi-Laplacian is L M^-1 L with the lumped
  /// areas M: two substitutions. q is smooth except for d^2 log(d) / (4 Theta) at the pole, with
  /// Theta the angle around the pole; q is finite, and positive at the pole for either sign of g.
  /// Interpolated is symmetric, and second order up to a logarithmic factor at the pole.
  /// SingularitySubtraction separates the non-smooth part: second order everywhere.
  BiLaplace
};

/// Sign of Green's functions near the pole.
enum class GreensSign
{
  Positive, ///< -Laplace g = delta - 1 / area
  Negative  ///< Laplace g = delta - 1 / area
};

/// Value of SingularitySubtraction at the pole itself, where the function is infinite.
enum class GreensPole
{
  CellAverage, ///< mean over a disk with the area of the cell of the vertex, or of a third of the
               ///< face if the target is inside one
  Infinite
};

/// Remark on the result of a query.
enum class GreensRemark
{
  None,
  /// Interpolated was used, because the mesh around the pole is too coarse; refine it. This remark
  /// has three causes. The largest usable disk for the logarithm is smaller than four mean edges;
  /// the default disk is smaller than twice the mean (over the area) of the longest side of
  /// triangles; or all corners of the pole's face have given values, which makes finite elements 0.
  TooCoarse,
  /// The regular part has kinks, because shortest paths from different sides meet within ten mean
  /// edges of the pole, or within the requested Radius, for example behind a spike or a sharp
  /// corner. Errors are still a fraction of the errors of Interpolated.
  NearRidge,
  /// Interpolated was used, because the triangle of the flipped mesh that contains the pole was not
  /// found.
  NoTriangle,
  /// Interpolated was used, because Localized is not applicable. Localized requires that no values
  /// around the pole are given, that distances around the pole are meaningful, and that there are
  /// at most a few hundred neighbors.
  NotLocalized
};

struct GreensQuery
{
  GreensMethod Method = GreensMethod::SingularitySubtraction;
  GreensOrder Order = GreensOrder::Laplace; ///< BiLaplace ignores Sign and Pole
  GreensSign Sign = GreensSign::Positive;
  GreensPole Pole = GreensPole::CellAverage;
  /// Radius of s, model units. 0 means 0.28 times the square root of the component's area (up to
  /// 0.35 on coarse meshes), at most 48 mean edges. The radius is smaller if shortest paths from
  /// different sides meet within it, or if the number of targets would make distances more
  /// expensive than the solve.
  double Radius = 0.0;
  /// Points, in addition to the vertices, whose values are computed.
  std::vector<SurfacePoint> Targets;
  bool WantIntegrals = false;
  ProgressCallback Progress; ///< may be empty
};

struct GreensResult
{
  std::vector<double> Values;       ///< per vertex; 0 in other components
  std::vector<double> TargetValues; ///< per target
  /// Per vertex, the lumped integral of g phi_i with the hat function phi_i of the vertex, if
  /// requested. sum Integrals[i] f_i + (mean of u) is the solution of -Laplace u = f, or Laplace^2
  /// u = f, at the pole.
  std::vector<double> Integrals;
  GreensMethod Method = GreensMethod::Vertex; ///< method that was used
  GreensRemark Remark = GreensRemark::None;
  double Radius = 0.0; ///< radius of s; 0 without s
};

/// Green's functions on the mesh of a solver, which must be ready and outlive the object. With
/// Neumann conditions, or without boundary, the weighted sum of g over the component of its pole is
/// 0; in other components g is 0. With Dirichlet conditions g is 0 on the boundary.
///
/// Formulas: L g = e_j - w for vertex j, with positive semidefinite L and weights w that sum to 1
/// per component, and w^T g = 0. Then G is symmetric, L G = I - w 1^T, and f_j = w^T f + sum_i G_ji
/// (L f)_i for every f.
class DGG_CORE_EXPORT GreensFunction
{
public:
  explicit GreensFunction(const PoissonSolver& solver);
  ~GreensFunction();
  GreensFunction(const GreensFunction&) = delete;
  GreensFunction& operator=(const GreensFunction&) = delete;

  /// Computes the Green's function of one point. Fails if PoissonSolver::CheckPole() does. May be
  /// called by several threads simultaneously.
  Status Run(const SurfacePoint& pole, const GreensQuery& query, GreensResult& result) const;
  /// Computes the Green's functions of several points; `results[k]` belongs to pole k. Consecutive
  /// blocks of eight poles are solved together, in about half the time. May be called by several
  /// threads simultaneously, each for its own blocks; progress is reported by the calling thread.
  Status Run(const std::vector<SurfacePoint>& poles, const GreensQuery& query,
    std::vector<GreensResult>& results) const;
  static constexpr Id PolesInBlock = 8;
  /// Maximum memory in bytes of one thread for a block of poles including results, per vertex and
  /// per target.
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
