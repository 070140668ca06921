// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Approximate distances by the heat method.
#ifndef dggHeatMethod_h
#define dggHeatMethod_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggVirtualSources.h" // for VirtualSources

#include <functional> // for checks of memory
#include <limits>     // for the number of triangles
#include <memory>     // for the systems
#include <vector>     // for the results

namespace dgg
{
class HeatSystem;

/// Boundary condition of the heat flow.
enum class HeatBoundary
{
  Neumann,   ///< insulated: isolines meet the boundary at right angles
  Dirichlet, ///< zero temperature: isolines run along the boundary
  Average    ///< mean of both, as Crane, Weischedel and Wardetzky advise
};

/// Range of the time step factor. At both ends the average error of the distances is large: 15 % at
/// the lower end, where heat flows along edges, and 23 % at the upper end, where the temperature is
/// nearly uniform. Beyond the range rounding errors dominate.
/// @{
constexpr double SmallestTimeStepFactor = 1e-6;
constexpr double LargestTimeStepFactor = 1e6;
/// @}

/// Limits beyond which results are unreliable. With time step factors outside this range, and in
/// components with fewer triangles, the average error of distances is at least 10 % (measured on
/// spheres, plates, scans and CAD parts).
/// @{
constexpr double SmallestUsefulFactor = 0.1;
constexpr double LargestUsefulFactor = 100.0;
constexpr Id FewestUsefulTriangles = 50;
/// @}

struct HeatOptions
{
  /// Factor c of the time step c h^2, dimensionless, where h is the mean edge length of the
  /// component after flips.
  double TimeStepFactor = 1.0;
  /// If true, edges are first flipped until they are Delaunay, which improves results on meshes
  /// with obtuse triangles.
  bool IntrinsicDelaunay = true;
  HeatBoundary Boundary = HeatBoundary::Neumann;
};

struct HeatQuery
{
  double MaximumDistance = Infinity; ///< vertices farther than this are reported as unreached
  bool WantNearestSource = false;
  bool WantVirtualSource = false;
  ProgressCallback Progress; ///< may be empty
};

struct HeatResult
{
  std::vector<double> Distances; ///< per vertex; Infinity where unreached
  /// Per vertex, index into the sources, found by descending the distances along edges; NoId where
  /// unreached. Empty unless requested.
  std::vector<Id> NearestSource;
  /// Virtual source of each vertex, as in SearchResult: the initial distance of the source, the
  /// remaining distance, and the polar angle at the vertex opposite to the gradient of the
  /// distances. Empty unless requested.
  VirtualSources Virtual;
  /// Smallest number of triangles of a component with a source; isolated vertices are not counted.
  Id FewestTriangles = (std::numeric_limits<Id>::max)();
};

/// The heat method (Crane, Weischedel and Wardetzky, "Geodesics in heat", 2013) on one mesh, which
/// must outlive the object. Heat flows from the sources for a short time; the normalized gradient
/// of the temperature is projected onto gradients of functions, which gives the distances. Two
/// linear systems are factorized in advance; a query takes two solves. The error is unbounded; the
/// average is usually 0.5 to 2.2 % on fine meshes, and larger on coarse meshes and close to
/// sources. Any triangle complex is accepted; vertices are reached in the components (through edges
/// and shared vertices) that have a source.
///
/// If the temperature underflows the range of double, beyond about 500 edges from the sources,
/// numbers with a larger range are used, with which a query takes several times as long.
///
/// Sources inside faces and on edges are loads at the corners. The distances are determined up to a
/// constant per component. The constant is chosen so that the corners of the sources have the
/// correct straight distances on average; for sources at vertices, the mean over the sources is
/// correct. Then distances below the smallest initial distance are raised to this initial distance,
/// and distances at the corners of a source are lowered to the straight distance from the source.
///
/// Shifting the result by the initial distance of the nearest source would be wrong, since the
/// initial distances determine which source is nearest and where the gradients turn. As the
/// temperature falls like exp(-d / sqrt(t)) with the distance, a source with initial distance o
/// gets exp(-o / sqrt(t)) of the heat, so that the gradients turn where d + o is equal. The
/// constant is then computed from the sources that are not dominated by another source.
class DGG_CORE_EXPORT HeatMethod
{
public:
  explicit HeatMethod(const SurfaceMesh& mesh);
  ~HeatMethod();
  HeatMethod(const HeatMethod&) = delete;
  HeatMethod& operator=(const HeatMethod&) = delete;

  /// Fails if the time step factor is out of range.
  static Status Check(const HeatOptions& options);

  /// Computes triangulation, matrices and factorizations; only data affected by changed options is
  /// recomputed. `checkMemory`, which may be empty, is called with GetEstimatedMemory() before
  /// additional factorizations. After a failure or a stop, a later call resumes with the remaining
  /// work. Fails like Check().
  Status Prepare(const HeatOptions& options, const ProgressCallback& progress,
    const std::function<Status(double bytes)>& checkMemory = {});
  /// Returns the estimated size in bytes of all data including factorizations, at most twice the
  /// actual size. May only be called after Prepare().
  double GetEstimatedMemory() const;

  /// Computes distances from the nearest source, after Prepare(). Fails like ExactGeodesics::Run().
  /// Also fails if the heat has a Dirichlet boundary and a source lies on the boundary. May be
  /// called by several threads simultaneously.
  Status Run(
    const std::vector<GeodesicSource>& sources, const HeatQuery& query, HeatResult& result) const;

  /// Returns the number of factorizations performed so far.
  int GetNumberOfFactorizations() const;

private:
  Status Check(const std::vector<GeodesicSource>& sources, const HeatQuery& query) const;

  const SurfaceMesh& Mesh;
  std::unique_ptr<HeatSystem> System;
};
}

#endif
