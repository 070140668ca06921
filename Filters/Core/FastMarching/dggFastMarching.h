// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Approximate distances by fast marching.
#ifndef dggFastMarching_h
#define dggFastMarching_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggVirtualSources.h" // for VirtualSources

#include <cstddef> // for std::size_t
#include <memory>  // for the prepared triangles
#include <vector>  // for the results

namespace dgg
{
class UnfoldedTriangles;

/// The shape of the front between two vertices that it has passed.
enum class MarchingUpdate
{
  Spherical, ///< around a point, as far away as the distances say: exact in the plane
  Planar     ///< straight, as Kimmel and Sethian have it: the solution of |grad d| = 1
};

struct MarchingOptions
{
  MarchingUpdate Update = MarchingUpdate::Spherical;
  /// Vertices farther than this are left unreached.
  double MaximumDistance = Infinity;
  bool WantVirtualSource = false;
  ProgressCallback Progress; ///< may be empty
};

struct MarchingResult
{
  std::vector<double> Distances; ///< per vertex; Infinity where unreached
  std::vector<Id> NearestSource; ///< per vertex, index into the sources; NoId where unreached
  /// Where the distance seems to come from, by the last update of the vertex, as in SearchResult:
  /// distance at the virtual source, straight distance from it, polar angle at the vertex towards
  /// it. Empty unless asked for.
  VirtualSources Virtual;
};

/// Kimmel and Sethian, "Computing geodesic paths on manifolds", 1998, on one mesh, which must
/// outlive it. Vertices become final in the order of their distances, each updated from triangles
/// of which two corners are final. At obtuse corners the faces beyond are unfolded until a vertex
/// splits the angle into two that are not obtuse. Nothing bounds the error: 0.1 to 1 % on average
/// is usual.
///
/// A front that comes round a vertex where geodesics may bend (saddle, boundary, irregular) goes on
/// around that vertex. Where fronts with different centres meet in one triangle, the one with the
/// smaller distance at its centre is taken; where sources with different initial distances are
/// behind them, both go along the edges only.
///
/// Any triangle complex will do: fronts cross into all faces of a non-manifold edge. Run() may be
/// called by several threads at once.
class DGG_CORE_EXPORT FastMarching
{
public:
  explicit FastMarching(const SurfaceMesh& mesh);
  ~FastMarching();
  FastMarching(const FastMarching&) = delete;
  FastMarching& operator=(const FastMarching&) = delete;

  /// Distances from the nearest of the sources. Fails as ExactGeodesics does.
  Status Run(const std::vector<GeodesicSource>& sources, const MarchingOptions& options,
    MarchingResult& result) const;

private:
  const SurfaceMesh& Mesh;
  std::unique_ptr<UnfoldedTriangles> Unfolded;
};
}

#endif
