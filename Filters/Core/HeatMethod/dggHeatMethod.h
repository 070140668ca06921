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

/// What heat does at the boundary of the surface.
enum class HeatBoundary
{
  Neumann,   ///< it stays inside: isolines meet the boundary at right angles
  Dirichlet, ///< it is cooled away: isolines run along the boundary
  Average    ///< the mean of both, as Crane, Weischedel and Wardetzky advise
};

/// The range of the time step factor. At either end the distances have little to do with the true
/// ones any more: they are off by 15 % on average at the lower end, where heat goes along edges,
/// and by 23 % at the upper, where it is nearly even. Beyond it rounding takes over.
/// @{
constexpr double SmallestTimeStepFactor = 1e-6;
constexpr double LargestTimeStepFactor = 1e6;
/// @}

/// Outside of this range of time step factors, and in components with fewer triangles, distances
/// are off by some 10 % and more on average (measured on spheres, plates, scans and parts).
/// @{
constexpr double SmallestUsefulFactor = 0.1;
constexpr double LargestUsefulFactor = 100.0;
constexpr Id FewestUsefulTriangles = 50;
/// @}

struct HeatOptions
{
  /// Heat flows for the time c h^2 with this c and the mean edge length h, that of the component
  /// and after flips.
  double TimeStepFactor = 1.0;
  /// Flip edges until they are Delaunay first: better on meshes with obtuse triangles.
  bool IntrinsicDelaunay = true;
  HeatBoundary Boundary = HeatBoundary::Neumann;
};

struct HeatQuery
{
  double MaximumDistance = Infinity; ///< vertices farther than this are given as unreached
  bool WantNearestSource = false;
  bool WantVirtualSource = false;
  ProgressCallback Progress; ///< may be empty
};

struct HeatResult
{
  std::vector<double> Distances; ///< per vertex; Infinity where unreached
  /// Per vertex, index into the sources, found by going down the distances along edges; NoId where
  /// unreached. Empty unless asked for.
  std::vector<Id> NearestSource;
  /// Where the distance seems to come from, as in SearchResult: the initial distance of the source,
  /// the rest, and the polar angle at the vertex against the gradient of the distances. Empty
  /// unless asked for.
  VirtualSources Virtual;
  /// Smallest number of triangles of a component with a source; isolated vertices are not counted.
  Id FewestTriangles = std::numeric_limits<Id>::max();
};

/// Crane, Weischedel and Wardetzky, "Geodesics in heat", 2013, on one mesh, which must outlive it:
/// heat flows from the sources for a short time; its gradient, made to be of length one, is that of
/// the distances up to what makes it a gradient. Two linear systems are factorized first; a query
/// then is two substitutions. Nothing bounds the error: 0.5 to 2.2 % on average is usual on fine
/// meshes, more on coarse ones and close to sources. Any triangle complex will do; vertices are
/// reached in the components (through edges and shared vertices) that have a source.
///
/// Where heat is too little for a double, as beyond some 500 edges from the sources, numbers with a
/// larger range take its place, in which a query takes several times as long.
///
/// Sources inside faces and edges are loads at the corners. The distances are known up to a
/// constant per component: it is chosen so that the corners of the sources are at their straight
/// distances on average, where sources are vertices so that the mean over them is what it should
/// be. Then distances below the least initial distance are raised to it, and those above what a
/// source gives to its own corners are lowered to that.
///
/// Initial distances. To shift the result by the initial distance of the nearest source would be
/// wrong: which one is nearest, and where the gradients turn, depends on the initial distances. As
/// heat falls like exp(-d / sqrt(t)) with the distance, a source with initial distance o gets
/// exp(-o / sqrt(t)) of the heat, and the gradients turn where d + o is equal. The constant is then
/// found from the sources that no other one seems to be closer to.
class DGG_CORE_EXPORT HeatMethod
{
public:
  explicit HeatMethod(const SurfaceMesh& mesh);
  ~HeatMethod();
  HeatMethod(const HeatMethod&) = delete;
  HeatMethod& operator=(const HeatMethod&) = delete;

  /// Triangulation, matrices and their factors: what the options change is done anew, the rest is
  /// kept. `checkMemory`, which may be empty, is asked before there are more factors than before,
  /// with GetEstimatedMemory(). After a failure or a stop, a later call starts with the part of the
  /// work that had not been done. Fails when the time step factor is out of range.
  Status Prepare(const HeatOptions& options, const ProgressCallback& progress,
    const std::function<Status(double bytes)>& checkMemory = {});
  /// Bytes that all takes when it is factorized, at most twice what they are. After Prepare().
  double GetEstimatedMemory() const;

  /// Distances from the nearest of the sources, after Prepare(). Fails as ExactGeodesics does; also
  /// when heat has a Dirichlet boundary and a source lies on it. May be called by several threads
  /// at once.
  Status Run(
    const std::vector<GeodesicSource>& sources, const HeatQuery& query, HeatResult& result) const;

  /// Factorizations done so far.
  int GetNumberOfFactorizations() const;

private:
  Status Check(const std::vector<GeodesicSource>& sources, const HeatQuery& query) const;

  const SurfaceMesh& Mesh;
  std::unique_ptr<HeatSystem> System;
};
}

#endif
