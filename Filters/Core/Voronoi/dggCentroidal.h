// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Moves sites to the centroids of their Voronoi cells, on surfaces and clouds (Lloyd's algorithm).
#ifndef dggCentroidal_h
#define dggCentroidal_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggGraphBuilder.h" // for links
#include "dggGraphSearch.h"  // for GraphSearch
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the sites

namespace dgg
{
/// Sites linked to the graph as seeds of a search, see GraphBuilder::Link().
struct LinkedSites
{
  std::vector<GraphSeed> Seeds;   ///< Source is the index of the site
  std::vector<double> Departures; ///< per seed, direction at the site; 0 for sites at vertices
};

/// Computes the seeds of surface points. `builder` may be null if all points are vertices.
DGG_CORE_EXPORT Status LinkSites(const std::vector<SurfacePoint>& sites,
  const GraphBuilder* builder, double accuracy, LinkedSites& linked);

struct CentroidalOptions
{
  int NumberOfIterations = 20;
  /// Stop if no site would move by more than this fraction of the mean edge length.
  double Tolerance = 1e-3;
  ProgressCallback Progress; ///< may be empty
};

/// Lloyd's iteration on a surface: every site moves repeatedly to the mean of its cell, so that the
/// cells become compact and of similar size. The iteration minimizes the energy, the sum over all
/// vertices of area times squared distance from the nearest site, where the area of a vertex is a
/// third of the area of its faces.
///
/// The mean is computed in the tangent plane of the site: a vertex of the cell is placed at its
/// (corrected) distance in the direction in which the path to it leaves the site, straightened like
/// the distance. The site then moves to the mean along a straightest geodesic. If the energy does
/// not decrease, all steps are halved; the iteration ends if that does not help.
///
/// `energies` receives the energy at the start and after each iteration; it is decreasing. Sites
/// without a cell do not move. Fails like LinkSites() and GraphSearch::Run(); then `sites` is
/// unchanged. `builder` is required because sites move into faces.
DGG_CORE_EXPORT Status MoveToCenters(const GraphSearch& search, const SurfaceMesh& mesh,
  const GraphBuilder& builder, double accuracy, const CentroidalOptions& options,
  std::vector<SurfacePoint>& sites, std::vector<double>& energies);

/// Lloyd's iteration on a cloud, where there are no directions and sites are points of the cloud.
/// The iteration minimizes the energy, the sum over all points of the squared distance from the
/// nearest site. All points have equal weight, so that there are more sites where points are
/// denser.
///
/// Seen from a site, a point of its cell is placed at its distance in the direction of the first
/// edge of the path to it. The target of the site is the mean of these positions; the site becomes
/// the point of its cell that is closest to the target in space. If the energy does not decrease,
/// only those sites move that are then closer to the points of their cells. If that does not help,
/// all steps are halved, and finally the iteration ends. Tolerance is not used.
///
/// `search` belongs to the graph of a cloud, `positions` are x y z per point of the cloud. Each
/// site is first moved to its nearest cloud point. `energies` receives the energy at the start and
/// after each iteration; it is decreasing. Fails like GraphSearch::Run(); then `sites` is
/// unchanged.
DGG_CORE_EXPORT Status MoveToCloudCenters(const GraphSearch& search, const double* positions,
  const CentroidalOptions& options, std::vector<SurfacePoint>& sites,
  std::vector<double>& energies);
}

#endif
