// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances on surfaces made of the Laplacian: biharmonic, commute-time, diffusion.
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
  /// 1 / lambda: a number. Grows without bound as the mesh is refined, since the Green's function
  /// of the Laplacian is infinite at its pole.
  CommuteTime,
  /// exp(-2 t lambda): one over a length (Coifman and Lafon, "Diffusion maps", 2006). From the
  /// eigenvalues only.
  Diffusion
};

enum class SpectralMethod
{
  Exact,   ///< all eigenvalues, by solving for Green's functions
  Spectrum ///< the smallest eigenvalues but 0 of each component
};

struct SpectralOptions
{
  SpectralKind Kind = SpectralKind::Biharmonic;
  SpectralMethod Method = SpectralMethod::Spectrum;
  Id NumberOfEigenvalues = 150; ///< of each component
  /// The time t of diffusion, a length squared. 0: a tenth of the inverse of the first eigenvalue
  /// of the component.
  double Time = 0.0;
};

/// Distances on the mesh of a solver, which must be ready and outlive it. Inside of faces,
/// functions are linear. All are distances of vectors, so metrics on each component; points in
/// different components are at distance Infinity.
///
/// The threads of a parallel loop report its progress, several at once.
class DGG_CORE_EXPORT SpectralDistance
{
public:
  explicit SpectralDistance(const PoissonSolver& solver);

  /// Finds the eigenpairs of the components of `sources` (empty: of all), or with the Exact method
  /// the diagonal of the Green's function, for which it solves for all vertices. Results of earlier
  /// calls are kept. Call again for other components, and when the solver is prepared with other
  /// options.
  Status Prepare(const SpectralOptions& options, const ParallelFor& parallel,
    const ProgressCallback& progress, const std::vector<SurfacePoint>& sources = {});
  /// Fail when the point does not exist, or has no face; a source, as well when it lies in a
  /// component whose triangles are too thin. May be asked before Prepare().
  /// @{
  Status CheckPlace(const SurfacePoint& point) const;
  Status CheckSource(const SurfacePoint& point) const;
  /// @}

  /// How often eigenvalues have been found.
  int GetNumberOfSpectra() const { return this->NumberOfSpectra; }

  /// From one point to all vertices.
  Status FromPoint(const SurfacePoint& source, std::vector<double>& distances) const;
  /// Between all of the first and all of the second points, row by row: the exact method solves
  /// for each point once, also when the second are the first (the same object), and holds the
  /// solutions, one number for each point and vertex.
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
  std::vector<Id> Places;        // per vertex, index in the pairs of its component
  std::vector<double> Diagonal;  // per vertex, of the Green's function
};
}

#endif
