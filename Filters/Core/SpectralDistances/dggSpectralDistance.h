// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Spectral distances on surfaces: biharmonic, commute-time, diffusion.
#ifndef dggSpectralDistance_h
#define dggSpectralDistance_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggEigenpairs.h"    // for Eigenpairs
#include "dggParallel.h"      // for ParallelFor
#include "dggPoissonSolver.h" // for PoissonSolver
#include "dggSurfacePoint.h"  // for points

#include <cstddef> // for std::size_t
#include <cstdint> // for the revision
#include <vector>  // for the results

namespace dgg
{
/// With eigenvalues lambda_i and functions v_i, the square of the distance of x and y is the sum of
/// (v_i(x) - v_i(y))^2 times ...
enum class SpectralKind
{
  /// 1 / lambda^2: a length; smooth, hardly depends on the mesh (Lipman, Rustamov and Funkhouser,
  /// "Biharmonic distance", 2010). Its square is q(x,x) + q(y,y) - 2 q(x,y), with the Green's
  /// function q of the bi-Laplacian.
  Biharmonic,
  /// 1 / lambda: dimensionless. Grows without bound as the mesh is refined, since the Green's
  /// function of the Laplacian is infinite at its pole.
  CommuteTime,
  /// exp(-2 t lambda): unit 1 / length (Coifman and Lafon, "Diffusion maps", 2006). Only available
  /// by eigenvalues.
  Diffusion
};

enum class SpectralMethod
{
  Exact,   ///< entire spectrum, by solving for Green's functions
  Spectrum ///< smallest non-zero eigenvalues of each component
};

struct SpectralOptions
{
  SpectralKind Kind = SpectralKind::Biharmonic;
  SpectralMethod Method = SpectralMethod::Spectrum;
  Id NumberOfEigenvalues = 150; ///< per component
  /// Diffusion time t, unit length^2. 0 means a tenth of the inverse of the first eigenvalue of the
  /// component.
  double Time = 0.0;
};

/// Distances on the mesh of a solver, which must be ready and outlive the object. Functions are
/// linear inside faces. All distances are norms of differences of vectors, hence metrics on each
/// component; points in different components have distance Infinity.
///
/// Progress of a parallel loop is reported by several threads simultaneously.
class DGG_CORE_EXPORT SpectralDistance
{
public:
  explicit SpectralDistance(const PoissonSolver& solver);

  /// Finds the eigenpairs of the components of `sources` (empty means all) or, with the Exact
  /// method, the diagonal of the Green's function, which requires a solution per vertex. Results of
  /// earlier calls are reused. Must be called again for other components, and after the solver has
  /// been prepared with other options.
  Status Prepare(const SpectralOptions& options, const ParallelFor& parallel,
    const ProgressCallback& progress, const std::vector<SurfacePoint>& sources = {});
  /// Fails if the point does not exist or has no face; CheckSource() also fails if the triangles of
  /// its component are too thin. May be called before Prepare().
  /// @{
  Status CheckPlace(const SurfacePoint& point) const;
  Status CheckSource(const SurfacePoint& point) const;
  /// @}

  /// Returns the number of spectra computed so far.
  int GetNumberOfSpectra() const { return this->NumberOfSpectra; }

  /// Computes the distances from one point to all vertices.
  Status FromPoint(const SurfacePoint& source, std::vector<double>& distances) const;
  /// Computes the distances between all of the first and all of the second points, row by row. The
  /// exact method solves once per point, also if `second` is the same object as `first`, and stores
  /// the solutions, one value per point and vertex.
  Status Between(const std::vector<SurfacePoint>& first, const std::vector<SurfacePoint>& second,
    const ParallelFor& parallel, const ProgressCallback& progress,
    std::vector<double>& distances) const;

  std::size_t GetMemorySize() const;

private:
  Status FindPairs(const std::vector<SurfacePoint>& sources, const ProgressCallback& progress);
  Status FindDiagonal(const ParallelFor& parallel, const ProgressCallback& progress);
  std::vector<double> LoadOf(const SurfacePoint& point) const;
  std::vector<double> PotentialOf(const SurfacePoint& point) const;
  std::vector<double> ColumnOf(std::vector<double> potential) const;
  double Product(const std::vector<double>& load, const std::vector<double>& a,
    const std::vector<double>& b) const;
  double Filter(const Eigenpairs& pairs, std::size_t k) const;
  std::vector<double> EmbeddingOf(const SurfacePoint& point) const;
  Status CheckPrepared() const;
  Status CheckPreparedSource(const SurfacePoint& point) const;
  double GetNumbersOfSolve() const;

  const PoissonSolver& Solver;
  SpectralOptions Options;
  bool IsPrepared = false;
  int NumberOfSpectra = 0;
  std::uint64_t Revision = 0;    // revision of the system at Prepare()
  std::vector<Eigenpairs> Pairs; // per component
  std::vector<Id> Places;        // per vertex, index in Eigenpairs::Vertices
  std::vector<double> Diagonal;  // per vertex, diagonal of the Green's function
};
}

#endif
