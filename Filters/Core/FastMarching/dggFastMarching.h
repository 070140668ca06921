// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Approximate distances by fast marching.
#ifndef dggFastMarching_h
#define dggFastMarching_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggVirtualSources.h" // for VirtualSources

#include <memory> // for the prepared triangles
#include <vector> // for the results

namespace dgg
{
class UnfoldedTriangles;

/// Shape of the front between two vertices that the front has passed.
enum class MarchingUpdate
{
  Spherical, ///< a circle that matches both distances: exact in the plane
  Planar     ///< a line, as by Kimmel and Sethian: solves |grad d| = 1
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
  /// Virtual source of each vertex, from its last update, as in SearchResult: distance at the
  /// virtual source, straight distance from it, polar angle at the vertex towards it. Empty unless
  /// requested.
  VirtualSources Virtual;
};

/// Fast marching (Kimmel and Sethian, "Computing geodesic paths on manifolds", 1998) on one mesh,
/// which must outlive the object. Vertices become final in order of their distances; each vertex is
/// updated from triangles with two final corners. At obtuse corners the faces beyond the opposite
/// edge are unfolded until a vertex splits the angle into two that are not obtuse. The error is
/// unbounded; 0.1 to 1 % on average is usual.
///
/// If geodesics may bend at a vertex (saddle, boundary, irregular), a front that passes the vertex
/// continues as a circle around the vertex. If fronts with different centers meet in one triangle,
/// the front with the smaller distance at its center is used. If these fronts come from sources
/// with different initial distances, both are propagated along the edges only.
///
/// Any triangle complex is accepted: fronts cross into all faces of a non-manifold edge. Run() may
/// be called by several threads simultaneously.
class DGG_CORE_EXPORT FastMarching
{
public:
  explicit FastMarching(const SurfaceMesh& mesh);
  ~FastMarching();
  FastMarching(const FastMarching&) = delete;
  FastMarching& operator=(const FastMarching&) = delete;

  /// Computes distances from the nearest source. Fails like ExactGeodesics::Run().
  Status Run(const std::vector<GeodesicSource>& sources, const MarchingOptions& options,
    MarchingResult& result) const;

private:
  const SurfaceMesh& Mesh;
  std::unique_ptr<UnfoldedTriangles> Unfolded;
};
}

#endif
