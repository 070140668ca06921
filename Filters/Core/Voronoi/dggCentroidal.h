// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Moves sites to the middle of their Voronoi cells, on surfaces and on clouds.
#ifndef dggCentroidal_h
#define dggCentroidal_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggGraphBuilder.h" // for links
#include "dggGraphSearch.h"  // for GraphSearch
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the sites

namespace dgg
{
/// What sites become seeds of a search by, see GraphBuilder::Link().
struct LinkedSites
{
  std::vector<GraphSeed> Seeds;   ///< numbered by Source
  std::vector<double> Departures; ///< per seed, the direction at the site; 0 for sites at vertices
};

/// Seeds of surface points. `builder` may be null when all of them are vertices.
DGG_CORE_EXPORT Status LinkSites(const std::vector<SurfacePoint>& sites,
  const GraphBuilder* builder, double accuracy, LinkedSites& linked);

struct CentroidalOptions
{
  int NumberOfIterations = 20;
  /// Stop when no site would move by more than this part of the mean edge length.
  double Tolerance = 1e-3;
  ProgressCallback Progress; ///< may be empty
};

/// Lloyd's iteration on a surface: every site moves to the mean of its cell, step by step, so that
/// the cells become compact and of similar size. What is made smaller is the energy, the sum over
/// all vertices of area times squared distance from the nearest site, where the area of a vertex is
/// a third of that of its faces.
///
/// The mean is taken in the tangent plane of the site: a vertex of the cell stands there at its
/// distance (corrected) and in the direction in which the way to it leaves the site, straightened
/// as the distance is. Then the site walks straight on to it. When the energy does not decrease,
/// all steps are halved; the iteration ends when that does not help.
///
/// `energies` receives the energy at the start and after each iteration; it decreases. Sites
/// without a cell stay where they are. Fails as LinkSites() and GraphSearch::Run() do; then `sites`
/// are unchanged. `builder` is needed: sites move into faces.
DGG_CORE_EXPORT Status MoveToCenters(const GraphSearch& search, const SurfaceMesh& mesh,
  const GraphBuilder& builder, double accuracy, const CentroidalOptions& options,
  std::vector<SurfacePoint>& sites, std::vector<double>& energies);

/// Lloyd's iteration on a cloud, where there are no directions and sites are points of the cloud.
/// What is made smaller is the energy, the sum over all points of their squared distance from the
/// nearest site; points count equally, so that there are more sites where points are denser.
///
/// As seen from a site, a point of its cell stands at its distance in the direction of the first
/// edge of the way to it. The site is to go to the mean of these, and becomes the point of its cell
/// that is closest to it in space. When the energy does not decrease, only those sites move that
/// are closer to the points of their cells then; when that does not help, all steps are halved, and
/// at last the iteration ends. Its Tolerance has no use.
///
/// `search` is that of the graph of a cloud, `positions` are those of its points, x y z each. Sites
/// that are near points of the cloud start as these. `energies` receives the energy at the start
/// and after each iteration; it decreases. Fails as GraphSearch::Run() does; then `sites` are
/// unchanged.
DGG_CORE_EXPORT Status MoveToCloudCenters(const GraphSearch& search, const double* positions,
  const CentroidalOptions& options, std::vector<SurfacePoint>& sites,
  std::vector<double>& energies);
}

#endif
